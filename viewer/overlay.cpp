#include "viewer/overlay.h"

#include <algorithm>
#include <string>
#include <vector>

#include "viewer/font.h"
#include "viewer/overlay_style.h"

namespace sir::viewer {
namespace {

bool values_shown(const Viewer& viewer) {
  return viewer.values_on() && viewer.viewport().multiple() >= kValuesFrom;
}

// The colour of every pixel that can be seen, r over g over b.
void draw_values(Canvas& canvas, const Frame& picture, const Viewport& viewport, int scale) {
  const Letterbox seen = viewport.visible(), box = viewport.box();
  const int m = viewport.multiple();
  const int letter = 3 * kLetterHeight * scale <= m && 3 * kLetterWidth * scale <= m ? scale : 1;
  const int line = kLetterHeight * letter;
  for (int y = seen.y; y < seen.y + seen.height; ++y)
    for (int x = seen.x; x < seen.x + seen.width; ++x) {
      const Rgb8 colour = rgb(picture.words[picture.offset(x, y)]);
      const Argb ink = legible_on(colour);
      int top = box.y + y * m + (m - 3 * line) / 2;
      for (const std::uint8_t value : {colour.r, colour.g, colour.b}) {
        const std::string text = std::to_string(value);
        canvas.text(box.x + x * m + (m - text_width(text, letter)) / 2, top, text, ink, letter);
        top += line;
      }
    }
}

// The line of the duel, and which method is on which side of it; while the map of the winners is
// shown also the colours that stand for them.
void draw_split(Canvas& canvas, const Viewer& viewer, int scale) {
  const Letterbox box = viewer.viewport().box();
  const int x = box.x + viewer.split_column() * viewer.viewport().multiple();
  canvas.line(x - 1, 0, x - 1, canvas.size().height - 1, kShade);
  canvas.line(x, 0, x, canvas.size().height - 1, kInk);
  const int height = kLinePitch * scale + 2 * kMargin;
  for (const int side : {0, 1}) {
    const bool active = viewer.active_side() == side;
    const std::string text =
        std::string(side == 0 ? "A " : "B ") + std::string(name(viewer.side(side).shown_method()));
    const int swatch = viewer.map() == Map::duel ? height : 0;
    const int width = text_width(text, scale) + 2 * kMargin + swatch;
    const int left = side == 0 ? x - 2 - width : x + 2;
    canvas.fill({left, 2, width, height}, kPanel);
    canvas.fill({left, 2, swatch, height}, argb(side == 0 ? kColourOfA : kColourOfB));
    canvas.text(left + swatch + kMargin, 2 + kMargin, text, active ? kAccent : kInk, scale);
  }
}

// A frame around a pixel that shows on any colour; small pixels get one at a distance.
void draw_target(Canvas& canvas, const Viewport& viewport, Place pixel) {
  const Letterbox box = viewport.box();
  const int m = viewport.multiple();
  const int away = m >= 8 ? 0 : 4;
  const Rectangle frame{box.x + pixel.x * m - away - 1, box.y + pixel.y * m - away - 1,
                        m + 2 * away + 2, m + 2 * away + 2};
  canvas.frame(frame, kInk);
  canvas.frame({frame.x - 1, frame.y - 1, frame.width + 2, frame.height + 2}, kShade);
}

// In the lower corner that is farther from the pixel, in large letters where that leaves most of
// the picture.
void draw_inspector(Canvas& canvas, Viewer& viewer, int scale, int bottom) {
  const std::vector<std::string> lines = viewer.inspection();
  int letters = 2 * scale;
  if (5 * block_height(lines.size(), letters) > 2 * canvas.size().height) letters = scale;
  const int width = block_width(lines, letters), height = block_height(lines.size(), letters);
  const Letterbox box = viewer.viewport().box();
  const auto pixel = viewer.inspected();
  const int x = pixel ? box.x + pixel->x * viewer.viewport().multiple() : 0;
  const int left = x < canvas.size().width / 2 ? canvas.size().width - width - 8 : 8;
  draw_block(canvas, {left, bottom - height - 8}, lines, letters);
}

void draw_message(Canvas& canvas, const Viewer& viewer, int scale) {
  const int height = strip_height(viewer, scale);
  const int top = canvas.size().height - height;
  canvas.fill({0, top, canvas.size().width, height}, kPanel);
  canvas.text(kMargin, top + kMargin,
              fitted(viewer.message(), canvas.size().width - 2 * kMargin, scale), kInk, scale);
}

}  // namespace

bool has_overlay(const Viewer& viewer) {
  return values_shown(viewer) || viewer.duel() || viewer.inspector_open() ||
         viewer.pixel_pinned() || !viewer.message().empty() || viewer.key_sheet_open() ||
         viewer.prompt().open() || !viewer.tally().empty();
}

void draw_overlay(Canvas& canvas, Viewer& viewer, int scale) {
  // Short texts are in letters that can be read at arm's length.
  const int large = canvas.size().width >= 800 * scale ? 2 * scale : scale;
  if (values_shown(viewer)) draw_values(canvas, viewer.picture(), viewer.viewport(), scale);
  if (viewer.duel()) draw_split(canvas, viewer, large);
  if (const auto pixel = viewer.inspected();
      pixel && (viewer.pixel_pinned() || viewer.inspector_open()))
    draw_target(canvas, viewer.viewport(), *pixel);
  const int bottom = canvas.size().height - strip_height(viewer, large);
  if (viewer.inspector_open() && !viewer.panel_shown())
    draw_inspector(canvas, viewer, scale, bottom);
  if (const auto lines = viewer.tally(); !lines.empty() && !viewer.panel_shown())
    draw_block(canvas, {8, 16 + kLinePitch * large}, lines, large);
  if (!viewer.message().empty()) draw_message(canvas, viewer, large);
  if (viewer.key_sheet_open()) draw_key_sheet(canvas, large);
  if (viewer.prompt().open()) draw_prompt(canvas, viewer.prompt(), large);
}

}  // namespace sir::viewer
