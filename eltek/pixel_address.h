// Where the next pixel goes: the column and row registers of the MA120 (our model; thesis 3.4
// gives the screen's size alone).
#pragma once

#include <cstddef>

#include "eltek/frame_buffer.h"

namespace sir::eltek {

/// Two 10-bit registers that move on by themselves, so that a row, or the whole screen, goes out
/// by one string instruction. Behind column 1023 comes column 0 of the next row, behind the last
/// row, 779, row 0. The row register also reaches 780 to 1023, where there is no memory: pixels
/// written there are lost, and 0 is read; behind 1023 comes row 0.
class PixelAddress {
 public:
  static constexpr int kBits = 10;

  int column() const { return column_; }
  int row() const { return row_; }

  /// Only the low 10 bits are wired.
  void set_column(int column) { column_ = column & kMask; }
  void set_row(int row) { row_ = row & kMask; }

  /// Whether there is a pixel.
  bool on_screen() const { return row_ < FrameBuffer::kRows; }

  /// Pixels from here, this one included, to where the address next returns to 0.
  std::size_t before_wrap() const;

  /// Moves on by so many pixels.
  void advance(std::size_t pixels);

  friend bool operator==(const PixelAddress&, const PixelAddress&) = default;

 private:
  static constexpr int kMask = (1 << kBits) - 1;

  int column_ = 0;
  int row_ = 0;
};

}  // namespace sir::eltek
