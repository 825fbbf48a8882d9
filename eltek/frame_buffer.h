// The pixel memory of the MA120: eight bit planes of 1024 x 780 (thesis 3.4).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sir::eltek {

/// Eight planes of one bit a pixel. Bit p of a pixel's index lies in plane p.
/// A plane is packed, 128 bytes a row, rows from the top; the leftmost of the
/// eight pixels of a byte is its highest bit.
///
/// The thesis gives resolution and number of planes. The packing and the
/// write mask are our model, after planar boards of the time.
///
/// Columns count from the left and rows from the top, both from 0; a place
/// outside the screen throws std::out_of_range.
class FrameBuffer {
 public:
  static constexpr int kColumns = 1024;
  static constexpr int kRows = 780;
  static constexpr int kPlanes = 8;
  static constexpr int kBytesPerRow = kColumns / 8;

  /// Every plane is 0 and may be written.
  FrameBuffer();

  /// Planes whose bit is 0 keep their content when pixels are written.
  void set_write_mask(std::uint8_t mask) { write_mask_ = mask; }
  std::uint8_t write_mask() const { return write_mask_; }

  void write(int column, int row, std::uint8_t index);
  std::uint8_t read(int column, int row) const;

  /// Writes neighbouring pixels of a row from (column, row) rightwards; the same as
  /// write() for each, eight pixels at a time where they fill whole bytes.
  void write_row(int column, int row, std::span<const std::uint8_t> indices);

  /// Writes one index to `count` pixels from (column, row) on, row after row; the same as write()
  /// for each. Throws std::out_of_range where they reach beyond the last row.
  void fill(int column, int row, std::size_t count, std::uint8_t index);

  /// Reads neighbouring pixels of a row, as write_row writes them.
  void read_row(int column, int row, std::span<std::uint8_t> indices) const;

  /// The packed bytes of one plane, 0..7: kRows * kBytesPerRow of them.
  std::span<const std::uint8_t> plane(int number) const;

 private:
  std::vector<std::uint8_t> bits_;  // plane after plane
  std::uint8_t write_mask_ = 0xFF;
};

}  // namespace sir::eltek
