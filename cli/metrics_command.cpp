#include "cli/metrics_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "cli/image_input.h"
#include "cli/output_path.h"
#include "quant/error_budget.h"
#include "quant/heat_map.h"
#include "quant/hue_loss.h"
#include "quant/lut.h"
#include "quant/metrics.h"
#include "tracer/atomic_file.h"
#include "tracer/error.h"
#include "tracer/text_file.h"
#include "viewer/png_file.h"

namespace sir::cli {
namespace {

using nlohmann::ordered_json;

/// The metrics in the order in which they are printed, under their names.
/// Without bound: the PSNR of equal images.
struct NamedMetric {
  std::string name;
  double (*value)(const quant::ImageMetrics&);
};

const std::vector<NamedMetric>& named_metrics() {
  using Metrics = quant::ImageMetrics;
  static const std::vector<NamedMetric> all{
      {"psnr",
       [](const Metrics& m) { return m.psnr.value_or(std::numeric_limits<double>::infinity()); }},
      {"rmse", [](const Metrics& m) { return m.rmse; }},
      {"de_mean", [](const Metrics& m) { return m.de_mean; }},
      {"de_p95", [](const Metrics& m) { return m.de_p95; }},
      {"de_max", [](const Metrics& m) { return m.de_max; }},
      {"ssim", [](const Metrics& m) { return m.ssim; }},
      {"colours", [](const Metrics& m) { return static_cast<double>(m.colours); }},
      {"banding", [](const Metrics& m) { return m.banding; }},
      {"hue_loss", [](const Metrics& m) { return m.hue_loss; }}};
  return all;
}

struct Budgets {
  quant::ErrorBudget difference, square;
};

/// All that is told.
struct Findings {
  quant::ImageMetrics metrics;
  quant::HueLoss hues;
  std::optional<Budgets> budgets;
};

int degrees(int plane) { return 10 * plane; }

ordered_json as_json(const quant::ErrorBudget& budget) {
  return {{"total", budget.total},
          {"entries", budget.entries},
          {"dac", budget.dac},
          {"mapping", budget.mapping}};
}

std::string as_json(const Findings& found) {
  ordered_json json;
  for (const NamedMetric& metric : named_metrics())
    json[metric.name] = metric.value(found.metrics);  // an infinite one is dumped as null
  json["colours"] = found.metrics.colours;
  json["hue_alarms"] = ordered_json::array();
  for (const int plane : found.hues.alarms) json["hue_alarms"].push_back(degrees(plane));
  if (found.budgets) {
    json["budget"] = as_json(found.budgets->difference);
    json["budget"]["mse"] = as_json(found.budgets->square);
  }
  return json.dump() + "\n";
}

std::string as_text(const quant::ErrorBudget& budget, const char* of) {
  return fmt::format("{}: {:.3f} = {:.3f} from the entries {:+.3f} DAC {:+.3f} mapping\n", of,
                     budget.total, budget.entries, budget.dac, budget.mapping);
}

std::string as_text(const Findings& found) {
  const quant::ImageMetrics& m = found.metrics;
  std::string text = fmt::format(
      "PSNR: {} (RMSE {:.3f})\n"
      "CIEDE2000: mean {:.3f}, 95 % of the pixels within {:.2f}, greatest {:.2f}\n"
      "SSIM: {:.4f}\n"
      "colours: {}\n"
      "banding: {:.4f}\n"
      "hue loss: {:.1f} % of the coloured pixels\n",
      m.psnr ? fmt::format("{:.2f} dB", *m.psnr) : "infinite, the images are equal", m.rmse,
      m.de_mean, m.de_p95, m.de_max, m.ssim, m.colours, m.banding, 100 * m.hue_loss);
  for (const auto& plane : found.hues.planes) {
    const auto& alarms = found.hues.alarms;
    if (std::find(alarms.begin(), alarms.end(), plane.plane) == alarms.end()) continue;
    const int hue = degrees(plane.plane);
    text += fmt::format("alarm: hue {} ({}) is gone: {} of {} {} shown in another hue or in grey\n",
                        hue, quant::hue_name(hue),
                        std::llround(plane.lost * static_cast<double>(plane.pixels)), plane.pixels,
                        plane.pixels == 1 ? "pixel is" : "pixels are");
  }
  if (found.budgets)
    text += as_text(found.budgets->difference, "CIEDE2000 through the LUT") +
            as_text(found.budgets->square, "square error through the LUT");
  return text;
}

void refuse_different_sizes(const MetricsOptions& options, ImageSize reference, ImageSize shown) {
  if (reference == shown) return;
  throw FileError(options.shown.string(), 0,
                  fmt::format("has {}x{} pixels, but {} has {}x{}; `sir show --crop` writes the "
                              "image's area of the screen alone",
                              shown.width, shown.height, options.reference.string(),
                              reference.width, reference.height));
}

/// Says which thresholds are not met. Returns whether all are.
bool all_met(const std::vector<Threshold>& thresholds, const quant::ImageMetrics& metrics) {
  bool met = true;
  for (const Threshold& threshold : thresholds) {
    const auto& all = named_metrics();
    const double value = std::find_if(all.begin(), all.end(), [&](const NamedMetric& metric) {
                           return metric.name == threshold.name;
                         })->value(metrics);
    const bool above = threshold.fails == Threshold::Fails::above;
    if (above ? value <= threshold.limit : value >= threshold.limit) continue;
    met = false;
    const std::string message = fmt::format("sir: {} is {}, {} the limit {}\n", threshold.name,
                                            value, above ? "above" : "below", threshold.limit);
    std::fputs(message.c_str(), stderr);
  }
  return met;
}

void write_heat_map(const MetricsOptions& options, const Planes& reference, const Planes& shown,
                    const Session& session) {
  refuse_input_file(*options.heat_map, options.reference);
  refuse_input_file(*options.heat_map, options.shown);
  if (options.lut) refuse_same_file(*options.heat_map, *options.lut);
  require_picture_name(*options.heat_map);
  viewer::write_rgb_png(*options.heat_map, quant::heat_map(reference, shown));
  detail(session, fmt::format("wrote {}: black CIEDE2000 0, blue {}, red {}, yellow {}, white {}",
                              options.heat_map->string(), quant::kWhiteHot / 4,
                              quant::kWhiteHot / 2, 3 * quant::kWhiteHot / 4, quant::kWhiteHot));
}

}  // namespace

const std::vector<std::string>& metric_names() {
  static const auto names = [] {
    std::vector<std::string> all;
    for (const NamedMetric& metric : named_metrics()) all.push_back(metric.name);
    return all;
  }();
  return names;
}

bool parse_threshold(std::string_view text, Threshold& threshold) {
  const auto equals = std::min(text.find('='), text.size());
  const std::string_view name = text.substr(0, equals);
  const auto& names = metric_names();
  double limit = 0;
  if (std::find(names.begin(), names.end(), name) == names.end() || equals == text.size() ||
      !parse_number(text.substr(equals + 1), limit))
    return false;
  threshold.name = name;
  threshold.limit = limit;
  return true;
}

int run_metrics(const MetricsOptions& options, const Session& session) {
  const Planes reference = load_image(options.reference, options.size);
  const Planes shown = load_image(options.shown, options.size);
  refuse_different_sizes(options, reference.size, shown.size);
  Findings found;
  if (options.lut) {
    const quant::Lut lut = quant::read_lut(*options.lut);
    found.budgets = {quant::error_budget(reference, lut),
                     quant::square_error_budget(reference, lut)};
  }
  found.metrics = quant::measure(reference, shown);
  found.hues = quant::hue_loss(reference, shown);
  if (options.heat_map) write_heat_map(options, reference, shown, session);
  print(options.json ? as_json(found) : as_text(found));
  return all_met(options.thresholds, found.metrics) ? kDone : kThreshold;
}

}  // namespace sir::cli
