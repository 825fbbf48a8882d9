// Painting into a buffer of pixels: panels, lines and text over the monitor's picture (thesis 3.5
// has the picture alone).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "viewer/argb.h"

namespace sir::viewer {

/// Black or white, whichever stands out more from the ground (by WCAG 2's contrast).
Argb legible_on(Rgb8 ground);

/// Pixels from x, y on, y downwards; nothing where a side is not positive.
struct Rectangle {
  int x = 0, y = 0, width = 0, height = 0;
  friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

/// What two rectangles share; of no size where they share nothing.
Rectangle intersection(const Rectangle& a, const Rectangle& b);

/// Paints into pixels that belong to another, who keeps them while the canvas is used. Whatever is
/// painted may lie beyond the canvas in part or in whole, at any coordinates that an int holds;
/// what is within the clip is the same as if there were none. One thread at a time.
class Canvas {
 public:
  /// Rows from the top, `pitch` words from one to the next. Throws std::invalid_argument for a
  /// pitch below the width and for fewer pixels than that takes.
  Canvas(std::span<Argb> pixels, ImageSize size, std::size_t pitch);
  Canvas(std::span<Argb> pixels, ImageSize size);

  ImageSize size() const { return size_; }
  Argb at(int x, int y) const { return pixels_[place(x, y)]; }

  /// Where painting has an effect: the whole canvas at first. What lies beyond the canvas is left
  /// out of it.
  void set_clip(const Rectangle& clip);
  void clip_nothing();
  const Rectangle& clip() const { return clip_; }

  /// The smallest rectangle around all that was painted so far; of no size before.
  Rectangle painted() const;

  /// All pixels of the rectangle; a translucent colour is a panel's background.
  void fill(const Rectangle& area, Argb colour);

  /// The outermost pixels of the rectangle, `thickness` of them on every side.
  void frame(const Rectangle& area, Argb colour, int thickness = 1);

  /// From one pixel to the other, both included, each once.
  void line(int x0, int y0, int x1, int y1, Argb colour);

  /// One line of UTF-8 text (viewer/font.h), x, y being its upper left corner; each point a square
  /// of scale x scale pixels. Returns where the next letter would stand.
  int text(int x, int y, std::string_view text, Argb colour, int scale = 1);

 private:
  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * pitch_ + static_cast<std::size_t>(x);
  }
  void note_painted(const Rectangle& area);
  void put(std::int64_t x, std::int64_t y, Argb colour);
  void fill_wide(std::int64_t x, std::int64_t y, std::int64_t width, std::int64_t height,
                 Argb colour);

  std::span<Argb> pixels_;
  ImageSize size_;
  std::size_t pitch_;
  Rectangle clip_;
  int left_ = 0, top_ = 0, right_ = 0, bottom_ = 0;  // of what was painted; right_ 0: nothing
};

}  // namespace sir::viewer
