// Measuring the rows of the price list.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "cli/cost/cost_data.h"
#include "cli/cost/lut_settings.h"
#include "cli/cost/tracer_settings.h"

namespace sir::cli {

struct MeasureOptions {
  int repeats = 5;
  int threads = 1;
  int truth_samples = 64;
  std::function<void(double)> progress;  ///< share done, in [0,1]; may be empty
  std::stop_token stop;
};

/// The tracer's part and the picture of its default. None where it was stopped.
struct TracerPart {
  CostPart part;
  Planes picture;
  std::optional<double> noise;  ///< PSNR of two true pictures; none where they are equal
};
std::optional<TracerPart> measure_tracer(const Scene& scene, ImageSize size,
                                         const std::vector<TracerSetting>& settings,
                                         const MeasureOptions& options);

/// The LUT's part: rows timed on one thread, differences from the true colours.
/// None where it was stopped.
std::optional<CostPart> measure_lut(const Planes& image, const std::vector<LutSetting>& settings,
                                    const MeasureOptions& options);

}  // namespace sir::cli
