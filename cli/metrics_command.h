// sir metrics: what an image lost on the way to the screen, in numbers.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/session.h"
#include "tracer/planes.h"

namespace sir::cli {

/// A limit that a metric must keep.
struct Threshold {
  enum class Fails { above, below };
  std::string name;  ///< one of metric_names()
  double limit = 0;
  Fails fails = Fails::above;  ///< equal to the limit passes
};

struct MetricsOptions {
  std::filesystem::path reference, shown;  ///< base names or PNG files
  ImageSize size;                          ///< of planes
  bool json = false;                       ///< print JSON
  std::vector<Threshold> thresholds;
  std::optional<std::filesystem::path> heat_map;  ///< PNG of the errors (quant/heat_map.h)
  std::optional<std::filesystem::path> lut;       ///< whose error budget is told
};

/// The metrics' names, which are the JSON's keys (quant::ImageMetrics).
const std::vector<std::string>& metric_names();

/// "NAME=X", X finite. False, and `threshold` as it was, for anything else.
bool parse_threshold(std::string_view text, Threshold& threshold);

/// Prints the metrics of the shown image against the reference, the hues that
/// are gone (in JSON "hue_alarms", in degrees) and, with `lut`, where the error
/// of the reference shown through that LUT comes from ("budget": means of
/// CIEDE2000; "mse" in it: of the bytes' squared errors). The PSNR of equal
/// images is null and above any limit.
/// Returns kThreshold, after printing, where a threshold is not met, with a
/// message for each. Throws FileError; images of different sizes are one.
int run_metrics(const MetricsOptions& options, const Session& session);

}  // namespace sir::cli
