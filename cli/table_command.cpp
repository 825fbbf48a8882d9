#include "cli/table_command.h"

#include <stdlib.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/interrupt.h"
#include "cli/progress.h"
#include "quant/choose.h"
#include "tracer/error.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"

namespace sir::cli {
namespace {

namespace fs = std::filesystem;

struct ThesisRow {
  const char* file;
  const char* title;
  int rgb_colours, rgb_seconds, hsv_colours, hsv_seconds;
};

// Table 4.1.
constexpr std::array<ThesisRow, 5> kThesis{{{"whitted", "WHITTED", 867, 115, 489, 85},
                                            {"calice", "CALICE", 723, 63, 410, 79},
                                            {"luminar", "LUMINAR", 400, 96, 206, 72},
                                            {"piramide", "PIRÂMIDE", 7619, 164, 3950, 86},
                                            {"lcg", "LCG", 1398, 128, 865, 84}}};

struct Measured {
  std::size_t colours = 0;
  double ms = 0;
};

struct Row {
  ThesisRow thesis;
  Measured rgb, hsv;
};

// A folder of our own that goes away with its content.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "sir-table-XXXXXX").string();
    if (!mkdtemp(name.data())) throw FileError(name, 0, "cannot be made");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

fs::path find_images(const std::optional<fs::path>& given) {
  if (given) return *given;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  const std::array<fs::path, 3> places{"images", program / "../../images",
                                       program / "../share/sir/images"};
  for (const fs::path& place : places)
    if (fs::exists(place / "whitted.CSG", ignored)) return place.lexically_normal();
  throw FileError("images", 0,
                  "the folder of the five scenes is not here; name it by --images DIR");
}

// What the thesis timed, from the planes' files to the LUT's.
double run_once(const fs::path& planes, quant::Space space, const fs::path& lut_file) {
  const auto start = std::chrono::steady_clock::now();
  quant::ChooseOptions choice;
  choice.space = space;
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

Row measure(const ThesisRow& thesis, const fs::path& planes, const fs::path& scratch, int repeats) {
  const auto cells = quant::occupied_cells(read_planes(planes, ImageSize{}));
  std::vector<double> rgb, hsv;
  for (int i = 0; i < repeats; ++i) {  // in turn, so that a slow spell hits both
    rgb.push_back(run_once(planes, quant::Space::rgb, scratch / "rgb.LUT"));
    hsv.push_back(run_once(planes, quant::Space::hsv, scratch / "hsv.LUT"));
  }
  return {thesis, {cells.rgb, median(rgb)}, {cells.hsv, median(hsv)}};
}

std::string minutes(int seconds) { return fmt::format("{}:{:02}", seconds / 60, seconds % 60); }

std::string as_text(const std::vector<Row>& rows) {
  std::string text =
      "Table 4.1 - median cut in RGB and in HSV, ours beside the thesis's (1989)\n\n"
      "            RGB                                  HSV\n"
      "            colours  thesis   time ms   thesis   colours  thesis   time ms   thesis\n";
  for (const Row& row : rows)
    text += fmt::format("{:<10}  {:>7}  {:>6}  {:>8.2f}   {:>6}   {:>7}  {:>6}  {:>8.2f}   {:>6}\n",
                        row.thesis.title, row.rgb.colours, row.thesis.rgb_colours, row.rgb.ms,
                        minutes(row.thesis.rgb_seconds), row.hsv.colours, row.thesis.hsv_colours,
                        row.hsv.ms, minutes(row.thesis.hsv_seconds));
  return text +
         "\ncolours: occupied cells of the grid; time: reading the planes, counting, choosing,\n"
         "writing the LUT (median of repeated runs; the thesis's in minutes and seconds).\n";
}

nlohmann::ordered_json half(const Measured& ours, int thesis_colours, int thesis_seconds) {
  return {{"colours", ours.colours},
          {"ms", ours.ms},
          {"thesis_colours", thesis_colours},
          {"thesis_seconds", thesis_seconds}};
}

std::string as_json(const std::vector<Row>& rows) {
  auto images = nlohmann::ordered_json::array();
  for (const Row& row : rows)
    images.push_back({{"image", row.thesis.title},
                      {"base", row.thesis.file},
                      {"rgb", half(row.rgb, row.thesis.rgb_colours, row.thesis.rgb_seconds)},
                      {"hsv", half(row.hsv, row.thesis.hsv_colours, row.thesis.hsv_seconds)}});
  return nlohmann::ordered_json{{"images", images}}.dump(2) + "\n";
}

}  // namespace

int run_table(const TableCommand& command, const Session& session) {
  const ScratchFolder scratch;
  std::vector<Row> rows;
  const fs::path images = command.planes ? fs::path() : find_images(command.images);
  for (const ThesisRow& thesis : kThesis) {
    fs::path planes = command.planes.value_or(scratch.path()) / thesis.file;
    if (!command.planes) {
      const Scene scene = read_scene(images / thesis.file);
      Progress progress(session, thesis.file);
      const auto result = render(scene, {}, progress.callback(), interruption());
      if (!result.complete) return kInterrupted;
      write_planes(planes, result.planes);
    }
    rows.push_back(measure(thesis, planes, scratch.path(), command.repeats));
    if (interrupted()) return kInterrupted;
  }
  print(command.json ? as_json(rows) : as_text(rows));
  return kDone;
}

}  // namespace sir::cli
