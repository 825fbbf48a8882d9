#include "viewer/composition.h"

#include <algorithm>

#include "viewer/argb.h"

namespace sir::viewer {

void lay_over(Frame& frame, const Planes& image, const eltek::Placement& at,
              const eltek::Area& frame_on_screen) {
  const eltek::Area& area = at.on_screen;
  for (int j = 0; j < area.size.height; ++j) {
    const auto from =
        static_cast<std::size_t>(at.image_row + j) * static_cast<std::size_t>(image.size.width) +
        static_cast<std::size_t>(at.image_column);
    Argb* to = frame.words.data() + frame.offset(area.column - frame_on_screen.column,
                                                 area.row - frame_on_screen.row + j);
    for (std::size_t i = 0; i < static_cast<std::size_t>(area.size.width); ++i)
      to[i] = argb(image.at(from + i));
  }
}

void take_right_part(Frame& frame, const Frame& other, int column) {
  const int first = std::clamp(column, 0, frame.size.width);
  for (int row = 0; row < frame.size.height; ++row)
    std::copy(other.words.data() + other.offset(first, row),
              other.words.data() + other.offset(0, row + 1),
              frame.words.data() + frame.offset(first, row));
}

void leave_entry(Frame& frame, std::span<const std::uint8_t> indices, std::uint8_t entry) {
  for (std::size_t i = 0; i < frame.words.size(); ++i) {
    if (indices[i] == entry) continue;
    const Rgb8 colour = rgb(frame.words[i]);
    // Rec. 601's weights in sixteenths, and a third of the light: plainly in the background.
    const auto grey = static_cast<std::uint8_t>((5 * colour.r + 9 * colour.g + 2 * colour.b) / 48);
    frame.words[i] = argb({grey, grey, grey});
  }
}

}  // namespace sir::viewer
