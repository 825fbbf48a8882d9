#include "cli/table_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "quant/best.h"

namespace sir::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string quality_line(const std::string& label, const TableCell& cell) {
  const auto& m = cell.metrics;
  std::string alarms;
  for (const int plane : cell.hues.alarms) alarms += fmt::format(" {}°", plane * 10);
  return fmt::format(
      "{:<14}  {:>6}  {:>5.2f}  {:>6.2f}  {:>6.2f}  {:>6.4f}  {:>6.3f}  {:>7.4f} {}\n", label,
      m.psnr ? fmt::format("{:.2f}", *m.psnr) : "equal", m.de_mean, m.de_p95, m.de_max, m.ssim,
      m.banding, m.hue_loss, alarms);
}

// What the thesis does not have, apart from what is compared with it.
std::string best_text(const TableData& data) {
  std::string text =
      "Beyond the thesis: the method best, for little difference to the eye\n\n"
      "            colours   time ms\n";
  for (const TableRow& row : data.rows)
    text +=
        fmt::format("{:<10}  {:>7}  {:>8.2f}\n", row.thesis.title, row.best.colours, row.best.ms);
  return text +
         "\ncolours: the image's different ones; time: of the same work; each pixel is shown as\n"
         "the entry nearest to the eye, not by the bytes.\n\n";
}

Json metrics_json(const TableCell& cell) {
  const auto& m = cell.metrics;
  Json json;
  if (m.psnr) json["psnr"] = *m.psnr;
  else json["psnr"] = nullptr;
  json["rmse"] = m.rmse;
  json["de_mean"] = m.de_mean;
  json["de_p95"] = m.de_p95;
  json["de_max"] = m.de_max;
  json["ssim"] = m.ssim;
  json["colours"] = m.colours;
  json["banding"] = m.banding;
  json["hue_loss"] = m.hue_loss;
  json["hue_alarms"] = cell.hues.alarms;
  return json;
}

Json half(const TableCell& ours, int thesis_colours, int thesis_seconds) {
  return {{"colours", ours.colours},
          {"ms", ours.ms},
          {"thesis_colours", thesis_colours},
          {"thesis_seconds", thesis_seconds},
          {"metrics", metrics_json(ours)}};
}

Json best_json(const TableCell& best) {
  return {{"goal", "perceptual"},    {"map", "perceptual"}, {"effort", quant::kUsualEffort},
          {"colours", best.colours}, {"ms", best.ms},       {"metrics", metrics_json(best)}};
}

Json fit_json(const quant::ClockFit& fit) {
  return {{"seconds_per", fit.seconds_per},
          {"predicted", fit.predicted},
          {"r2", fit.r2},
          {"leave_one_image_out", fit.leave_one_image_out},
          {"calice_rgb_faster", fit.calice_rgb_faster}};
}

Json clock_json(const ClockReading& reading) {
  Json json{{"split", reading.split}, {"shrink", reading.shrink}};
  json["work"] = Json::array();
  for (const auto& sample : reading.samples)
    json["work"].push_back({{"image", sample.image},
                            {"space", sample.space == quant::Space::rgb ? "rgb" : "hsv"},
                            {"pixels_read", sample.work.pixels_read},
                            {"conversions", sample.work.conversions},
                            {"cells_visited", sample.work.cells_visited},
                            {"measured_seconds", sample.measured_seconds}});
  json["by_work"] = fit_json(quant::fit_clock(reading.samples));
  json["by_counts"] = fit_json(quant::fit_counts(reading.samples));
  return json;
}

}  // namespace

std::string table_text(const TableData& data) {
  std::string text =
      "Table 4.1 - median cut in RGB and in HSV, ours beside the thesis's (1989)\n\n"
      "            RGB                                  HSV                                  "
      "RGB/HSV time\n"
      "            colours  thesis   time ms   thesis   colours  thesis   time ms   thesis     "
      "ours  thesis\n";
  for (const TableRow& row : data.rows)
    text += fmt::format(
        "{:<10}  {:>7}  {:>6}  {:>8.2f}   {:>6}   {:>7}  {:>6}  {:>8.2f}   {:>6}   {:>6.2f}  "
        "{:>6.2f}\n",
        row.thesis.title, row.rgb.colours, row.thesis.rgb_colours, row.rgb.ms,
        minutes(row.thesis.rgb_seconds), row.hsv.colours, row.thesis.hsv_colours, row.hsv.ms,
        minutes(row.thesis.hsv_seconds), row.rgb.ms / row.hsv.ms,
        double(row.thesis.rgb_seconds) / row.thesis.hsv_seconds);
  text +=
      "\ncolours: occupied cells of the grid; time: reading the planes, counting, choosing,\n"
      "writing the LUT (median of repeated runs; the thesis's in minutes and seconds).\n\n";
  text += best_text(data);
  text +=
      "Quality of the three LUTs, on the DAC of 6 bits (dE: CIEDE2000; hues lost: share of the\n"
      "coloured pixels, and the hues of which nothing is left)\n\n"
      "                  PSNR     dE     p95     max    SSIM  banding  hues lost\n";
  for (const TableRow& row : data.rows)
    for (const TableMethod& method : kTableMethods)
      text += quality_line(fmt::format("{} {}", row.thesis.title, method.name), row.*method.cell);
  return text + "\n" + clock_text(data.clock);
}

std::string table_json(const TableData& data) {
  auto images = Json::array();
  for (const TableRow& row : data.rows)
    images.push_back({{"image", row.thesis.title},
                      {"base", row.thesis.file},
                      {"rgb", half(row.rgb, row.thesis.rgb_colours, row.thesis.rgb_seconds)},
                      {"hsv", half(row.hsv, row.thesis.hsv_colours, row.thesis.hsv_seconds)},
                      {"best", best_json(row.best)}});
  auto clock = Json::array();
  for (const ClockReading& reading : data.clock) clock.push_back(clock_json(reading));
  return Json{{"images", images}, {"clock_1989", clock}}.dump(2) + "\n";
}

}  // namespace sir::cli
