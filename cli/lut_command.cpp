#include "cli/lut_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <string>
#include <utility>

#include "cli/image_input.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "quant/lut.h"
#include "tracer/atomic_file.h"
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

/// A LUT and what is told of it.
struct Chosen {
  quant::Lut lut;
  std::size_t entries = 0;
  quant::CellCounts cells;
  Times ms;
  std::optional<double> error;  // of `best`
};

Planes load_pixels(const std::filesystem::path& input, ImageSize size) {
  Planes image = load_image(input, size);
  if (image.size.pixels() == 0)
    throw FileError(input.string(), 0, "has no pixels to choose colours from");
  return image;
}

Chosen choose_by_thesis(const LutOptions& options) {
  Chosen chosen;
  Times& ms = chosen.ms;
  const quant::ChooseOptions& choice = options.choice;
  const Planes image =
      timed(ms.read, [&] { return load_pixels(options.inputs.front(), options.size); });
  const auto cells = timed(ms.count, [&] { return quant::count_for(image, choice); });
  chosen.lut = timed(ms.choose, [&] { return quant::choose_from(cells, choice); });
  chosen.entries = chosen.lut.chosen;

  auto other = choice;  // the grid that was not counted yet
  other.space = choice.space == quant::Space::rgb ? quant::Space::hsv : quant::Space::rgb;
  chosen.cells = {cells.size(), quant::count_for(image, other).size()};
  if (choice.space == quant::Space::hsv) std::swap(chosen.cells.rgb, chosen.cells.hsv);
  return chosen;
}

/// The occupied cells of several images together.
class CellUnion {
 public:
  void add(const Planes& image) {
    for (const auto& cell : quant::count_cells(image, quant::RgbGrid())) rgb_.insert(cell.at);
    for (const auto& cell : quant::count_cells(image, quant::HsvGrid())) hsv_.insert(cell.at);
  }
  quant::CellCounts counts() const { return {rgb_.size(), hsv_.size()}; }

 private:
  std::set<quant::GridPoint> rgb_, hsv_;
};

// How much each pixel counts, 0 to 255.
std::vector<std::uint8_t> load_mask(const std::filesystem::path& file, const Planes& image,
                                    const std::filesystem::path& of) {
  Planes mask = load_image(file, image.size);
  if (mask.size != image.size)
    throw FileError(
        file.string(), 0,
        fmt::format("is a mask of {}x{}, but {} has {}x{}", mask.size.width, mask.size.height,
                    of.string(), image.size.width, image.size.height));
  if (mask.channel[0] != mask.channel[1] || mask.channel[0] != mask.channel[2])
    throw FileError(file.string(), 0, "is no grey image, which a mask must be");
  return std::move(mask.channel[0]);
}

// Planes of the HSV grid that no entry is left for.
std::string lost_hues_text(std::vector<int> planes) {
  constexpr int kGrey = 36;  // the last
  std::sort(planes.begin(), planes.end());
  const bool grey = planes.back() == kGrey;
  if (grey) planes.pop_back();
  for (int& plane : planes) plane *= 10;
  std::string text = "no entry is left for ";
  if (!planes.empty()) text += fmt::format("the hue of {} degrees", fmt::join(planes, ", "));
  if (grey) text += planes.empty() ? "grey" : " and for grey";
  return text;
}

Chosen choose_best(const LutOptions& options, const Session& session) {
  const BestCommand& command = *options.best;
  Chosen chosen;
  Times& ms = chosen.ms;
  quant::BestOptions best = command.options;
  if (command.from) {
    best.from = timed(ms.read, [&] { return quant::read_lut(*command.from); });
    if (command.dac && *command.dac != best.from->dac)
      throw FileError(command.from->string(), 0, "is of another DAC than --bits says");
    best.dac = best.from->dac;
  }
  quant::WeightedColours colours;
  CellUnion cells;
  for (std::size_t i = 0; i < options.inputs.size(); ++i) {
    const auto& input = options.inputs[i];
    const Planes image = timed(ms.read, [&] { return load_pixels(input, options.size); });
    std::vector<std::uint8_t> mask;
    if (!command.masks.empty())
      mask = timed(ms.read, [&] { return load_mask(command.masks[i], image, input); });
    timed(ms.count, [&] { colours.add(image, mask); });
    if (options.inputs.size() == 1) chosen.cells = quant::occupied_cells(image);
    else cells.add(image);
  }
  if (options.inputs.size() > 1) chosen.cells = cells.counts();
  if (colours.all().empty())
    throw FileError(command.masks.front().string(), 0, "leaves no pixel to choose colours from");

  Progress progress(session, "choosing colours");
  const auto choice = timed(ms.choose, [&] {
    return quant::choose_best(colours, best, progress.callback(), interruption());
  });
  progress.finish();
  chosen.lut = choice.lut;
  chosen.entries = choice.entries;
  chosen.error = choice.error;
  if (!choice.lost_hues.empty()) note(session, lost_hues_text(choice.lost_hues));
  return chosen;
}

std::string as_json(const Chosen& chosen) {
  const Times& ms = chosen.ms;
  return fmt::format(
      R"({{"cells_rgb":{},"cells_hsv":{},"entries":{},{}"ms":{{"read":{:.3f},"count":{:.3f},)"
      R"("choose":{:.3f},"write":{:.3f},"total":{:.3f}}}}})"
      "\n",
      chosen.cells.rgb, chosen.cells.hsv, chosen.entries,
      chosen.error ? fmt::format(R"("error":{:.4f},)", *chosen.error) : "", ms.read, ms.count,
      ms.choose, ms.write, ms.total());
}

std::string as_text(const std::filesystem::path& output, const Chosen& chosen,
                    const LutOptions& options) {
  const std::size_t entries = chosen.entries;
  const Times& ms = chosen.ms;
  std::string text = fmt::format("{}: {} {} chosen\n", output.string(), entries,
                                 entries == 1 ? "entry" : "entries");
  if (chosen.error)
    text +=
        options.best->options.goal == quant::Goal::perceptual
            ? fmt::format(
                  "error: {:.2f} by CIEDE2000's form for small differences (root of the mean "
                  "square)\n",
                  *chosen.error)
            : fmt::format(
                  "error: at most {:.2f} levels (root of the mean square of a colour's distance)\n",
                  *chosen.error);
  return text + fmt::format(
                    "colours: {} in the RGB grid, {} in the HSV grid\n"
                    "time: {:.1f} ms (read {:.1f}, count {:.1f}, choose {:.1f}, write {:.1f})\n",
                    chosen.cells.rgb, chosen.cells.hsv, ms.total(), ms.read, ms.count, ms.choose,
                    ms.write);
}

}  // namespace

int run_lut(const LutOptions& options, const Session& session) {
  const auto output =
      options.output.value_or(with_suffix(base_name(options.inputs.front()), "LUT"));
  for (const auto& input : options.inputs) refuse_input_file(output, input);
  if (options.best) {
    for (const auto& mask : options.best->masks) refuse_input_file(output, mask);
    if (options.best->from) refuse_same_file(output, *options.best->from);
  }
  require_writable(output);
  Chosen chosen = options.best ? choose_best(options, session) : choose_by_thesis(options);
  if (interrupted()) return kInterrupted;
  timed(chosen.ms.write, [&] { quant::write_lut(output, chosen.lut); });
  print(options.json ? as_json(chosen) : as_text(output, chosen, options));
  if (options.best && options.best->options.reserved.any())
    note(session, "show it with the same --reserve, so that no pixel takes a reserved entry");
  detail(session, output.string() + " written");
  return kDone;
}

}  // namespace sir::cli
