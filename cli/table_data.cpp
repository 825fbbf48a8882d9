#include "cli/table_data.h"

#include <algorithm>
#include <chrono>
#include <fstream>

#include <fmt/format.h>

#include "cli/cost/lut_work.h"
#include "quant/shown_through.h"
#include "tracer/error.h"

namespace sir::cli {
namespace {

// What the thesis timed, from the planes' files to the LUT's.
double run_once(const std::filesystem::path& planes, const LutChoice& choice,
                const std::filesystem::path& lut_file) {
  const auto start = std::chrono::steady_clock::now();
  const quant::Lut lut = chosen_by(choice, read_planes(planes, ImageSize{})).lut;
  // Not by write_lut(): waiting for the disk to be sure of a file that nobody
  // keeps would drown everything else.
  if (!(std::ofstream(lut_file) << quant::lut_text(lut) << std::flush))
    throw FileError(lut_file.string(), 0, "cannot be written");
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

LutChoice median_cut_in(quant::Space space) {
  quant::ChooseOptions choice;
  choice.space = space;
  return choice;
}

TableCell judge(const Planes& image, const LutChoice& choice, Search search, double ms) {
  const ChosenLut chosen = chosen_by(choice, image);
  TableCell cell;
  cell.colours = chosen.colours;
  cell.ms = ms;
  cell.lut = chosen.lut;
  cell.indices = mapped_by({search, quant::Dither::none}, image, cell.lut);
  cell.shown = quant::as_seen(image.size, cell.indices, cell.lut);
  cell.metrics = quant::measure(image, cell.shown);
  cell.hues = quant::hue_loss(image, cell.shown);
  return cell;
}

}  // namespace

TableRow measure_row(const ThesisRow& thesis, const std::filesystem::path& planes,
                     const std::filesystem::path& scratch, int repeats) {
  TableRow row{thesis, read_planes(planes, ImageSize{}), {}, {}, {}};
  const LutChoice in_rgb = median_cut_in(quant::Space::rgb);
  const LutChoice in_hsv = median_cut_in(quant::Space::hsv);
  const LutChoice by_best = quant::BestOptions{};
  std::vector<double> rgb, hsv, best;
  for (int i = 0; i < repeats; ++i) {  // in turn, so that a slow spell hits both
    rgb.push_back(run_once(planes, in_rgb, scratch / "rgb.LUT"));
    hsv.push_back(run_once(planes, in_hsv, scratch / "hsv.LUT"));
  }
  // Not in their turn: it is long, and would leave them cold caches.
  for (int i = 0; i < repeats; ++i) best.push_back(run_once(planes, by_best, scratch / "best.LUT"));
  row.rgb = judge(row.image, in_rgb, Search::exact, median(rgb));
  row.hsv = judge(row.image, in_hsv, Search::exact, median(hsv));
  row.best = judge(row.image, by_best, Search::perceptual, median(best));
  return row;
}

std::vector<ClockReading> clock_of(const std::vector<TableRow>& rows) {
  std::vector<ClockImage> images;
  for (const TableRow& row : rows)
    images.push_back({row.thesis.title, row.image, double(row.thesis.rgb_seconds),
                      double(row.thesis.hsv_seconds)});
  return clock_readings(images);
}

std::string minutes(int seconds) { return fmt::format("{}:{:02}", seconds / 60, seconds % 60); }

}  // namespace sir::cli
