#include "viewer/composition.h"

#include <algorithm>
#include <cstddef>

namespace sir::viewer {

void lay_over(Frame& frame, const Planes& image, const eltek::Placement& at,
              const eltek::Area& frame_on_screen, const Columns& columns) {
  const eltek::Area& area = at.on_screen;
  // In the frame.
  const int left = area.column - frame_on_screen.column, top = area.row - frame_on_screen.row;
  const int first = std::max(left, columns.first);
  const int end = std::min(left + area.size.width, columns.end);
  for (int j = 0; j < area.size.height; ++j) {
    const std::size_t from =
        static_cast<std::size_t>(at.image_row + j) * static_cast<std::size_t>(image.size.width) +
        static_cast<std::size_t>(at.image_column + first - left);
    const std::uint8_t* r = image.channel[0].data() + from;
    const std::uint8_t* g = image.channel[1].data() + from;
    const std::uint8_t* b = image.channel[2].data() + from;
    Argb* to = frame.words.data() + frame.offset(first, top + j);
    for (int i = 0; i < end - first; ++i) to[i] = argb({r[i], g[i], b[i]});
  }
}

Argb in_background(Argb colour) {
  const Rgb8 c = rgb(colour);
  // Rec. 601's weights in sixteenths, and a third of the light: plainly in the background.
  const auto grey = static_cast<std::uint8_t>((5 * c.r + 9 * c.g + 2 * c.b) / 48);
  return argb({grey, grey, grey});
}

void leave_entry(IndexWords& words, std::uint8_t mask, std::uint8_t entry) {
  for (std::size_t i = 0; i < words.size(); ++i)
    if ((i & mask) != entry) words[i] = in_background(words[i]);
}

}  // namespace sir::viewer
