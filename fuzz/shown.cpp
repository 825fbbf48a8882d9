#include "fuzz/shown.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "eltek/display_driver.h"
#include "fuzz/target.h"
#include "quant/best.h"
#include "quant/choose.h"
#include "quant/nearest.h"

namespace sir::fuzz {
namespace {

constexpr int kThesisMethods = 4;
static_assert(kMethods == kThesisMethods + 2);

void check_file(const quant::Lut& lut) {
  TextFile file("made.LUT", quant::lut_text(lut));
  const quant::Lut again = quant::read_lut(file);
  require(again.entry == lut.entry && again.dac == lut.dac && again.chosen <= lut.chosen,
          "a LUT that is written reads as what it was");
}

void check_screen(const Planes& image, const quant::Lut& lut,
                  const std::vector<std::uint8_t>& indices) {
  // One machine for all inputs: every show goes over the whole screen.
  static eltek::Ma120 monitor;
  const eltek::Area area = eltek::show_image(monitor, {"made", image.size, indices}, lut);
  const auto width = static_cast<std::size_t>(image.size.width);
  std::vector<Rgb8> line(eltek::FrameBuffer::kColumns);
  const Rgb8 around = lut.seen(eltek::nearest_to_black(lut));
  for (int row = -1; row <= image.size.height; ++row) {
    monitor.scan_line(area.row + row,
                      std::span<Rgb8, eltek::FrameBuffer::kColumns>(line.data(), line.size()));
    const auto left = static_cast<std::size_t>(area.column);
    require(line[left - 1] == around && line[left + width] == around,
            "an image is framed by what is nearest to black");
    if (row < 0 || row == image.size.height) continue;
    for (std::size_t i = 0; i < width; ++i)
      require(line[left + i] == lut.seen(indices[static_cast<std::size_t>(row) * width + i]),
              "a pixel is seen as its entry of the LUT");
  }
}

void show(const Planes& image, const quant::Lut& lut) {
  require(lut.chosen >= 1 && lut.chosen <= quant::kLutEntries, "a LUT has 1 to 256 colours");
  check_file(lut);
  const auto indices = quant::map_to_lut(image, lut);
  require(indices == quant::map_exhaustively(image, lut),
          "the fast search finds the nearest entries");
  check_screen(image, lut, indices);
}

}  // namespace

void show_by_method(const Planes& image, int method) {
  if (method >= kMethods) return;
  if (method >= kThesisMethods) {
    quant::WeightedColours colours;
    colours.add(image);
    quant::BestOptions options;
    options.goal = method % 2 == 0 ? quant::Goal::perceptual : quant::Goal::psnr;
    options.effort = quant::kMinEffort;
    show(image, quant::choose_best(colours, options).lut);
    return;
  }
  quant::ChooseOptions options;
  options.method = method / 2 == 0 ? quant::Method::frequency : quant::Method::median;
  options.space = method % 2 == 0 ? quant::Space::rgb : quant::Space::hsv;
  const quant::Lut lut = quant::choose_lut(image, options);
  const quant::CellCounts cells = quant::occupied_cells(image);
  const std::size_t occupied = method % 2 == 0 ? cells.rgb : cells.hsv;
  if (occupied <= quant::kLutEntries)
    require(lut.chosen == occupied, "no more cells than entries: an entry for each");
  show(image, lut);
}

}  // namespace sir::fuzz
