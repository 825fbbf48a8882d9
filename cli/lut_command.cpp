#include "cli/lut_command.h"

#include <fmt/format.h>

#include <chrono>
#include <string>
#include <utility>

#include "cli/image_input.h"
#include "quant/lut.h"
#include "tracer/error.h"
#include "tracer/scene_path.h"

namespace sir::cli {
namespace {

using Clock = std::chrono::steady_clock;

struct Times {
  double read = 0, count = 0, choose = 0, write = 0;  // milliseconds
  double total() const { return read + count + choose + write; }
};

/// Does the work and adds its time.
template <typename Work>
auto timed(double& milliseconds, Work work) {
  struct Watch {
    double& sum;
    Clock::time_point start = Clock::now();
    ~Watch() { sum += std::chrono::duration<double, std::milli>(Clock::now() - start).count(); }
  } const watch{milliseconds};
  return work();
}

std::string as_json(const quant::CellCounts& cells, std::size_t entries, const Times& ms) {
  return fmt::format(
      R"({{"cells_rgb":{},"cells_hsv":{},"entries":{},"ms":{{"read":{:.3f},"count":{:.3f},)"
      R"("choose":{:.3f},"write":{:.3f},"total":{:.3f}}}}})"
      "\n",
      cells.rgb, cells.hsv, entries, ms.read, ms.count, ms.choose, ms.write, ms.total());
}

std::string as_text(const std::filesystem::path& output, const quant::CellCounts& cells,
                    std::size_t entries, const Times& ms) {
  return fmt::format(
      "{}: {} {} chosen\n"
      "colours: {} in the RGB grid, {} in the HSV grid\n"
      "time: {:.1f} ms (read {:.1f}, count {:.1f}, choose {:.1f}, write {:.1f})\n",
      output.string(), entries, entries == 1 ? "entry" : "entries", cells.rgb, cells.hsv,
      ms.total(), ms.read, ms.count, ms.choose, ms.write);
}

}  // namespace

int run_lut(const LutOptions& options, const Session& session) {
  const quant::ChooseOptions& choice = options.choice;
  const auto output = options.output.value_or(with_suffix(base_name(options.input), "LUT"));
  Times ms;
  const Planes image = timed(ms.read, [&] { return load_image(options.input, options.size); });
  if (image.size.pixels() == 0)
    throw FileError(options.input.string(), 0, "has no pixels to choose colours from");
  refuse_input_file(output, options.input);

  const auto cells = timed(ms.count, [&] { return quant::count_for(image, choice); });
  const auto lut = timed(ms.choose, [&] { return quant::choose_from(cells, choice); });
  timed(ms.write, [&] { quant::write_lut(output, lut); });

  auto other = choice;  // the grid that was not counted yet
  other.space = choice.space == quant::Space::rgb ? quant::Space::hsv : quant::Space::rgb;
  quant::CellCounts counts{cells.size(), quant::count_for(image, other).size()};
  if (choice.space == quant::Space::hsv) std::swap(counts.rgb, counts.hsv);
  print(options.json ? as_json(counts, lut.chosen, ms) : as_text(output, counts, lut.chosen, ms));
  detail(session, output.string() + " written");
  return kDone;
}

}  // namespace sir::cli
