#include "panel_text.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace sir::test {
namespace {

// A text as ink and ground.
struct Stencil {
  int width = 0, height = 0;
  std::vector<bool> ink;
};

// Letters are drawn from an atlas, each at a whole pixel.
Stencil stencil(std::string_view text) {
  static ImFontAtlas atlas;
  static const ImFont& font = *atlas.AddFontDefault();
  unsigned char* alpha = nullptr;
  int across = 0, down = 0;
  atlas.GetTexDataAsAlpha8(&alpha, &across, &down);
  const auto whole = [](float value) { return static_cast<int>(std::lround(value)); };
  Stencil made;
  for (const char letter : text) {
    const ImFontGlyph& glyph = *font.FindGlyph(static_cast<ImWchar>(letter));
    made.width += whole(glyph.AdvanceX);
    made.height = std::max(made.height, whole(glyph.Y1));  // some reach below the line
  }
  made.ink.resize(static_cast<std::size_t>(made.width) * static_cast<std::size_t>(made.height));
  int pen = 0;
  for (const char letter : text) {
    const ImFontGlyph& glyph = *font.FindGlyph(static_cast<ImWchar>(letter));
    const int u = whole(glyph.U0 * static_cast<float>(across));
    const int v = whole(glyph.V0 * static_cast<float>(down));
    for (int y = whole(glyph.Y0); y < whole(glyph.Y1); ++y)
      for (int x = whole(glyph.X0); x < whole(glyph.X1); ++x)
        if (alpha[(v + y - whole(glyph.Y0)) * across + u + x - whole(glyph.X0)] != 0)
          made.ink.at(static_cast<std::size_t>(y * made.width + pen + x)) = true;
    pen += whole(glyph.AdvanceX);
  }
  // Lines above and below reach between: its own ink's rows count.
  const auto last = std::find(made.ink.rbegin(), made.ink.rend(), true);
  made.height = static_cast<int>((made.ink.rend() - last - 1) / made.width) + 1;
  const auto first = std::find(made.ink.begin(), made.ink.end(), true);
  const auto above = (first - made.ink.begin()) / made.width;
  made.ink.erase(made.ink.begin(), made.ink.begin() + above * made.width);
  made.height -= static_cast<int>(above);
  return made;
}

bool stands_at(const eltek::Screen& screen, const Stencil& stencil, Rgb8 ink, int x, int y) {
  for (int j = 0; j < stencil.height; ++j)
    for (int i = 0; i < stencil.width; ++i)
      if ((screen.pixels[screen.offset(x + i, y + j)] == ink) !=
          stencil.ink[static_cast<std::size_t>(j * stencil.width + i)])
        return false;
  return true;
}

// Whether no letter stands beside it.
bool stands_alone(const eltek::Screen& screen, const Stencil& stencil, int x, int y) {
  constexpr int kMargin = 6;  // a letter is 7 wide, a button's edge 4
  for (int j = 0; j < stencil.height; ++j)
    for (int i = 1; i <= kMargin; ++i)
      for (const int column : {x - i, x + stencil.width - 1 + i})
        if (column >= 0 && column < screen.size.width && screen.at(column, y + j) == kPanelInk)
          return false;
  return true;
}

template <typename Fits>
std::optional<viewer::Place> find(const eltek::Screen& screen, const Stencil& wanted, int from_row,
                                  const Fits& fits) {
  for (int y = std::max(0, from_row); y + wanted.height <= screen.size.height; ++y)
    for (int x = 0; x + wanted.width <= screen.size.width; ++x)
      if (fits(x, y)) return viewer::Place{x + wanted.width / 2, y + wanted.height / 2};
  return std::nullopt;
}

}  // namespace

std::optional<viewer::Place> find_text(const eltek::Screen& screen, std::string_view text, Rgb8 ink,
                                       int from_row) {
  const Stencil wanted = stencil(text);
  return find(screen, wanted, from_row,
              [&](int x, int y) { return stands_at(screen, wanted, ink, x, y); });
}

std::optional<viewer::Place> find_label(const eltek::Screen& screen, std::string_view text,
                                        int from_row) {
  const Stencil wanted = stencil(text);
  return find(screen, wanted, from_row, [&](int x, int y) {
    return stands_at(screen, wanted, kPanelInk, x, y) && stands_alone(screen, wanted, x, y);
  });
}

}  // namespace sir::test
