#include "cli/cost/cost_columns.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sir::cli {
namespace {

using Row = const CostRow&;

// Three digits or all before the point.
std::string time_cell(double ms) {
  return fmt::format("{:.{}f}", ms, ms < 10 ? 2 : ms < 100 ? 1 : 0);
}
std::string psnr_cell(const std::optional<double>& psnr) {
  return psnr ? fmt::format("{:.2f}", *psnr) : "equal";
}
std::string ratio_cell(double ratio) {
  return fmt::format("{:.{}f}", ratio, ratio < 9.995 ? 2 : 1);
}

std::vector<CostColumn> common() {
  return {{"", "choice", [](Row r) { return (r.front ? "* " : "  ") + r.name; }},
          {"time", "ms", [](Row r) { return time_cell(r.time.median); }},
          {"time", "quartiles",
           [](Row r) {
             return r.time.runs < 2 ? std::string("-")
                                    : time_cell(r.time.low) + ".." + time_cell(r.time.high);
           }},
          {"time", "ratio", [](Row r) { return ratio_cell(r.ratio.median); }},
          {"time", "runs", [](Row r) { return std::to_string(r.time.runs); }},
          {"picture", "PSNR dB", [](Row r) { return psnr_cell(r.picture.psnr); }},
          {"picture", "largest", [](Row r) { return std::to_string(r.picture.largest); }},
          {"picture", "dE mean", [](Row r) { return fmt::format("{:.3f}", r.picture.de_mean); }},
          {"picture", "pixels", [](Row r) { return std::to_string(r.picture.pixels); }}};
}

std::string of_points(Row row, std::string (*cell)(const Difference&)) {
  return row.points ? cell(*row.points) : "";
}

std::string of_lut(Row row, std::string (*cell)(const LutFigures&)) {
  return row.lut ? cell(*row.lut) : "";
}

using Points = const Difference&;
using Figures = const LutFigures&;

}  // namespace

const std::vector<CostColumn>& tracer_columns() {
  static const std::vector<CostColumn> columns = [] {
    auto all = common();
    const std::vector<CostColumn> more{
        {"points", "PSNR dB",
         [](Row r) { return of_points(r, [](Points p) { return psnr_cell(p.psnr); }); }},
        {"points", "largest",
         [](Row r) { return of_points(r, [](Points p) { return std::to_string(p.largest); }); }},
        {"points", "dE mean",
         [](Row r) {
           return of_points(r, [](Points p) { return fmt::format("{:.3f}", p.de_mean); });
         }},
        {"points", "wrong",
         [](Row r) { return of_points(r, [](Points p) { return std::to_string(p.pixels); }); }},
        {"pixels", "rounded",
         [](Row r) { return r.rounded ? std::to_string(*r.rounded) : std::string(); }},
        {"pixels", "changed", [](Row r) { return std::to_string(r.changed); }}};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return columns;
}

const std::vector<CostColumn>& lut_columns() {
  static const std::vector<CostColumn> columns = [] {
    auto all = common();
    const std::vector<CostColumn> times{
        {"time", "choose",
         [](Row r) {
           return of_lut(r, [](Figures f) { return time_cell(spread_of(f.choose_ms).median); });
         }},
        {"time", "map", [](Row r) {
           return of_lut(r, [](Figures f) { return time_cell(spread_of(f.map_ms).median); });
         }}};
    all.insert(all.begin() + 2, times.begin(), times.end());
    const std::vector<CostColumn> more{
        {"picture", "dE p95",
         [](Row r) {
           return of_lut(r, [](Figures f) { return fmt::format("{:.2f}", f.de_p95); });
         }},
        {"picture", "blurred",
         [](Row r) {
           return of_lut(r, [](Figures f) { return fmt::format("{:.3f}", f.de_blurred); });
         }},
        {"picture", "hues lost",
         [](Row r) {
           return of_lut(r, [](Figures f) { return fmt::format("{:.4f}", f.hue_loss); });
         }},
        {"LUT", "colours",
         [](Row r) { return of_lut(r, [](Figures f) { return std::to_string(f.colours); }); }},
        {"LUT", "entries",
         [](Row r) { return of_lut(r, [](Figures f) { return std::to_string(f.entries); }); }}};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return columns;
}

std::vector<std::pair<std::string, std::string>> cost_legend(const CostReport& report) {
  const auto has = [&](std::optional<CostPart> CostImage::*part) {
    return std::any_of(report.images.begin(), report.images.end(),
                       [&](const CostImage& image) { return (image.*part).has_value(); });
  };
  std::vector<std::pair<std::string, std::string>> legend{
      {"*",
       "on the Pareto front: no other row is as fast and as good, and better in one of both; "
       "by the median time and the picture's PSNR, however small the difference"},
      {"ms", "median of the runs, which take turns, each round beginning with another row"},
      {"quartiles", "the middle half of the runs lies between them"},
      {"ratio", "to the default (the first row): median of the ratios within the rounds"},
      {"runs", "rows that take more than ten times the default's time run less often"},
      {"largest", "greatest difference of a byte"},
      {"dE mean", "mean CIEDE2000; about 1 is just visible"},
      {"pixels", "those that are not the same, by however little"}};
  if (has(&CostImage::tracer)) {
    std::string truth;
    for (const CostImage& image : report.images)
      if (image.tracer) truth = image.truth;
    legend.insert(
        legend.end(),
        {{"tracer, time",
          fmt::format(
              "preparing and tracing on {}, by the clock; --budget counts this",
              report.threads == 1 ? "1 thread" : fmt::format("{} threads", report.threads))},
         {"tracer, picture",
          fmt::format("against the truth: {}; made once, with a seed that no row has. --target "
                      "counts this PSNR",
                      truth)},
         {"tracer, points",
          "rows of one ray through each pixel's centre, against the same truth with that one "
          "ray; `wrong` are the pixels that differ"},
         {"rounded",
          "rows that differ from the default only in how they calculate: pixels that "
          "differ from the default calculated as the truth is"},
         {"changed", "pixels that differ from the default's picture"}});
  }
  if (has(&CostImage::lut))
    legend.insert(
        legend.end(),
        {{"LUT, time",
          "counting the colours and choosing 256 (choose), and finding each pixel's entry (map), "
          "on 1 thread, its processor time; --budget counts both where there is no scene"},
         {"LUT, picture",
          "as the monitor shows it, against the true colours; dE p95: 95 % of the "
          "pixels are within; blurred: dE mean after a Gaussian blur of both by one pixel, in "
          "linear light, which is fair to dither; hues lost: share of the coloured pixels that "
          "land in another hue plane or in grey"},
         {"best",
          "the method best, beyond the thesis; pixels take the entry nearest by the eye (--map "
          "perceptual), unless the row says --map rgb or --goal psnr: then by the bytes"},
         {"colours",
          "occupied cells of the grid; RGB has 5 bits unless it says otherwise, HSV "
          "36x30x30 with greys up to 0.2; for best, the different colours of the picture"}});
  return legend;
}

std::string title_of(const CostImage& image) {
  return fmt::format("{}, {}x{}", image.name, image.size.width, image.size.height);
}

}  // namespace sir::cli
