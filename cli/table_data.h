// What `sir table` measures (thesis 4.4).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/clock_report.h"
#include "quant/choose.h"
#include "quant/hue_loss.h"
#include "quant/metrics.h"

namespace sir::cli {

/// A row of Table 4.1: colours counted and seconds taken in 1989.
struct ThesisRow {
  const char* file;   ///< the scene's name
  const char* title;  ///< the image's, as printed
  int rgb_colours, rgb_seconds, hsv_colours, hsv_seconds;
};

inline constexpr std::array<ThesisRow, 5> kThesisTable{
    {{"whitted", "WHITTED", 867, 115, 489, 85},
     {"calice", "CALICE", 723, 63, 410, 79},
     {"luminar", "LUMINAR", 400, 96, 206, 72},
     {"piramide", "PIRÂMIDE", 7619, 164, 3950, 86},
     {"lcg", "LCG", 1398, 128, 865, 84}}};

/// One image by one method.
struct TableCell {
  std::size_t colours = 0;  ///< occupied cells; of `best` the image's different colours
  double ms = 0;            ///< median time of reading, counting, choosing, writing
  quant::Lut lut;
  std::vector<std::uint8_t> indices;  ///< of the LUT, one a pixel
  Planes shown;                       ///< those as the monitor shows them
  quant::ImageMetrics metrics;
  quant::HueLoss hues;
};

struct TableRow {
  ThesisRow thesis;
  Planes image;
  TableCell rgb, hsv;  ///< the thesis's: by the median cut, each pixel the nearest by the bytes
  TableCell best;      ///< beyond the thesis: by `best`, each pixel the nearest by the eye
};

/// A method and its name, of a person's reading.
struct TableMethod {
  const char* name;
  TableCell TableRow::*cell;
};

inline constexpr std::array<TableMethod, 3> kTableMethods{
    {{"RGB", &TableRow::rgb}, {"HSV", &TableRow::hsv}, {"best", &TableRow::best}}};

struct TableData {
  std::vector<TableRow> rows;
  std::vector<ClockReading> clock;  ///< the work of 1989, by each reading of the thesis
};

/// Times and judges the median cuts and `best` of an image whose planes are in files. Runs
/// in the two spaces alternate, those of `best` follow, `repeats` of each. `scratch`: a folder for
/// LUTs that nobody keeps. Throws FileError.
TableRow measure_row(const ThesisRow& thesis, const std::filesystem::path& planes,
                     const std::filesystem::path& scratch, int repeats);

/// The work of 1989 for all rows.
std::vector<ClockReading> clock_of(const std::vector<TableRow>& rows);

/// "1:55", from seconds.
std::string minutes(int seconds);

}  // namespace sir::cli
