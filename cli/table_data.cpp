#include "cli/table_data.h"

#include <algorithm>
#include <chrono>
#include <fstream>

#include <fmt/format.h>

#include "quant/shown_through.h"

namespace sir::cli {
namespace {

// What the thesis timed, from the planes' files to the LUT's.
double run_once(const std::filesystem::path& planes, const quant::ChooseOptions& choice,
                const std::filesystem::path& lut_file) {
  const auto start = std::chrono::steady_clock::now();
  const quant::Lut lut = quant::choose_lut(read_planes(planes, ImageSize{}), choice);
  // Not by write_lut(): waiting for the disk to be sure of a file that nobody
  // keeps would drown everything else.
  std::ofstream(lut_file) << quant::lut_text(lut) << std::flush;
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

quant::ChooseOptions median_cut_in(quant::Space space) {
  quant::ChooseOptions choice;
  choice.space = space;
  return choice;
}

TableCell judge(const Planes& image, quant::Space space, std::size_t colours, double ms) {
  TableCell cell;
  cell.colours = colours;
  cell.ms = ms;
  cell.lut = quant::choose_lut(image, median_cut_in(space));
  cell.shown = quant::shown_through(image, cell.lut);
  cell.metrics = quant::measure(image, cell.shown);
  cell.hues = quant::hue_loss(image, cell.shown);
  return cell;
}

}  // namespace

TableRow measure_row(const ThesisRow& thesis, const std::filesystem::path& planes,
                     const std::filesystem::path& scratch, int repeats) {
  TableRow row{thesis, read_planes(planes, ImageSize{}), {}, {}};
  std::vector<double> rgb, hsv;
  for (int i = 0; i < repeats; ++i) {  // in turn, so that a slow spell hits both
    rgb.push_back(run_once(planes, median_cut_in(quant::Space::rgb), scratch / "rgb.LUT"));
    hsv.push_back(run_once(planes, median_cut_in(quant::Space::hsv), scratch / "hsv.LUT"));
  }
  const auto cells = quant::occupied_cells(row.image);
  row.rgb = judge(row.image, quant::Space::rgb, cells.rgb, median(rgb));
  row.hsv = judge(row.image, quant::Space::hsv, cells.hsv, median(hsv));
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
