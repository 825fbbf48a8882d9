#include "cli/terminal_output.h"

#include <unistd.h>

#include <algorithm>
#include <map>

#include "cli/session.h"
#include "quant/best.h"
#include "quant/colour_points.h"
#include "quant/image_pair.h"
#include "quant/map_image.h"
#include "viewer/half_blocks.h"
#include "viewer/sixel.h"
#include "viewer/terminal.h"

namespace sir::cli {
namespace {

constexpr int kUsualColumns = 80;
constexpr quant::DacBits kBytes{{8, 8, 8}};

// Every colour as a register of its own; none where there are too many.
std::optional<eltek::IndexedScreen> in_registers(const eltek::Screen& screen) {
  eltek::IndexedScreen indexed{screen.size, {}, {}, kBytes};
  std::map<std::uint32_t, std::size_t> known;
  indexed.indices.reserve(screen.pixels.size());
  for (const Rgb8 pixel : screen.pixels) {
    const auto [at, is_new] = known.try_emplace(quant::packed(pixel), known.size());
    if (at->second >= quant::kLutEntries) return std::nullopt;
    if (is_new) indexed.palette[at->second] = pixel;
    indexed.indices.push_back(static_cast<std::uint8_t>(at->second));
  }
  return indexed;
}

// The 256 colours are chosen out of the MA120's: those are what percents hold.
eltek::IndexedScreen reduced(const eltek::Screen& screen) {
  const Planes planes = to_planes(screen);
  quant::WeightedColours colours;
  colours.add(planes);
  const quant::Lut lut = quant::choose_best(colours).lut;
  eltek::IndexedScreen indexed{screen.size, {}, {}, lut.dac};
  indexed.indices = quant::map_image(planes, lut, {quant::Goal::perceptual, {}, {}});
  for (std::size_t i = 0; i < indexed.palette.size(); ++i) indexed.palette[i] = lut.seen(i);
  return indexed;
}

eltek::IndexedScreen as_registers(const eltek::IndexedScreen& screen,
                                  const std::optional<eltek::Crt>& crt) {
  if (!crt) return screen;
  if (crt->options().is_colour_map())
    return {screen.size, screen.indices, crt->palette(screen), kBytes};
  const eltek::Screen shown = crt->show(screen);
  if (auto indexed = in_registers(shown)) return *std::move(indexed);
  return reduced(shown);
}

eltek::Screen as_colours(const eltek::IndexedScreen& screen, const std::optional<eltek::Crt>& crt) {
  if (crt) return crt->show(screen);
  eltek::Screen shown{screen.size, {}};
  shown.pixels.reserve(screen.indices.size());
  for (const std::uint8_t index : screen.indices) shown.pixels.push_back(screen.palette[index]);
  return shown;
}

}  // namespace

TerminalForm settle(TerminalForm form) {
  if (form != TerminalForm::automatic) return form;
  if (::isatty(STDOUT_FILENO) != 1) return TerminalForm::sixel;
  return viewer::terminal_has_sixel() ? TerminalForm::sixel : TerminalForm::blocks;
}

void print_screen(const eltek::IndexedScreen& screen, const std::optional<eltek::Crt>& crt,
                  TerminalForm form) {
  if (form == TerminalForm::blocks) {
    const int columns = viewer::terminal_columns(STDOUT_FILENO).value_or(kUsualColumns);
    print(viewer::half_blocks(as_colours(screen, crt), columns));
  } else {
    print(viewer::sixel(as_registers(screen, crt)) + "\n");
  }
}

}  // namespace sir::cli
