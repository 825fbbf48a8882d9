#include "eltek/frame_buffer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>

namespace sir::eltek {
namespace {

constexpr std::size_t kPlaneBytes =
    static_cast<std::size_t>(FrameBuffer::kRows) * FrameBuffer::kBytesPerRow;

void require_on_screen(int column, int row, std::size_t count) {
  if (row < 0 || row >= FrameBuffer::kRows || column < 0 || column > FrameBuffer::kColumns ||
      count > static_cast<std::size_t>(FrameBuffer::kColumns - column))
    throw std::out_of_range("a pixel outside the MA120's screen");
}

// Offset, within a plane, of the byte that holds the pixel.
std::size_t byte_offset(int column, int row) {
  return static_cast<std::size_t>(row) * FrameBuffer::kBytesPerRow +
         static_cast<std::size_t>(column / 8);
}

std::uint8_t bit_of(int column) { return static_cast<std::uint8_t>(0x80u >> (column % 8)); }

// Transposes 8x8 bits; row 0 is the highest byte, column 0 the highest bit.
// H. S. Warren, Hacker's Delight, section 7-3: swaps blocks of 1, 2, 4 bits.
std::uint64_t transpose(std::uint64_t x) {
  x = (x & 0xAA55AA55AA55AA55u) | ((x & 0x00AA00AA00AA00AAu) << 7) |
      ((x >> 7) & 0x00AA00AA00AA00AAu);
  x = (x & 0xCCCC3333CCCC3333u) | ((x & 0x0000CCCC0000CCCCu) << 14) |
      ((x >> 14) & 0x0000CCCC0000CCCCu);
  return (x & 0xF0F0F0F00F0F0F0Fu) | ((x & 0x00000000F0F0F0F0u) << 28) |
         ((x >> 28) & 0x00000000F0F0F0F0u);
}

// For each byte of a plane its eight pixels: bit 0 of byte k, from the lowest, is pixel k from the
// left.
constexpr auto kPixelsOf = [] {
  std::array<std::uint64_t, 256> pixels{};
  for (std::size_t byte = 0; byte < pixels.size(); ++byte)
    for (int k = 0; k < 8; ++k)
      if ((byte >> (7 - k) & 1) != 0) pixels[byte] |= std::uint64_t{1} << (8 * k);
  return pixels;
}();

}  // namespace

FrameBuffer::FrameBuffer() : bits_(kPlanes * kPlaneBytes) {}

void FrameBuffer::write(int column, int row, std::uint8_t index) {
  require_on_screen(column, row, 1);
  const std::uint8_t bit = bit_of(column);
  for (int p = 0; p < kPlanes; ++p) {
    if (((write_mask_ >> p) & 1) == 0) continue;
    const std::size_t plane_start = static_cast<std::size_t>(p) * kPlaneBytes;
    std::uint8_t& byte = bits_[plane_start + byte_offset(column, row)];
    const bool set = ((index >> p) & 1) != 0;
    byte = static_cast<std::uint8_t>(set ? byte | bit : byte & ~bit);
  }
}

std::uint8_t FrameBuffer::read(int column, int row) const {
  require_on_screen(column, row, 1);
  unsigned index = 0;
  for (int p = 0; p < kPlanes; ++p)
    if ((plane(p)[byte_offset(column, row)] & bit_of(column)) != 0) index |= 1u << p;
  return static_cast<std::uint8_t>(index);
}

void FrameBuffer::write_row(int column, int row, std::span<const std::uint8_t> indices) {
  require_on_screen(column, row, indices.size());
  std::size_t i = 0;
  for (; i < indices.size() && column % 8 != 0; ++i) write(column++, row, indices[i]);
  for (; i + 8 <= indices.size(); i += 8, column += 8) {
    std::uint64_t pixels = 0;
    for (std::size_t k = 0; k < 8; ++k) pixels = pixels << 8 | indices[i + k];
    const std::uint64_t planes = transpose(pixels);  // plane p is byte p from the lowest
    std::uint8_t* byte = &bits_[byte_offset(column, row)];
    for (int p = 0; p < kPlanes; ++p, byte += kPlaneBytes)
      if (((write_mask_ >> p) & 1) != 0) *byte = static_cast<std::uint8_t>(planes >> (8 * p));
  }
  for (; i < indices.size(); ++i) write(column++, row, indices[i]);
}

void FrameBuffer::fill(int column, int row, std::size_t count, std::uint8_t index) {
  require_on_screen(column, row, count > 0 ? 1 : 0);
  // Rows lie one behind the other, so that a run over several is one run of bits.
  const std::size_t first = byte_offset(column, row) * 8 + static_cast<std::size_t>(column % 8);
  if (count > 8 * kPlaneBytes - first)
    throw std::out_of_range("pixels beyond the last row of the MA120's screen");
  if (count == 0) return;
  const std::size_t end = first + count;
  const auto head = static_cast<std::uint8_t>(0xFFu >> (first % 8));
  const auto tail = static_cast<std::uint8_t>(~(0xFFu >> (end % 8)));  // 0: it ends with a byte
  for (int p = 0; p < kPlanes; ++p) {
    if (((write_mask_ >> p) & 1) == 0) continue;
    const bool set = ((index >> p) & 1) != 0;
    std::uint8_t* plane = &bits_[static_cast<std::size_t>(p) * kPlaneBytes];
    const auto change = [&](std::size_t byte, std::uint8_t bits) {
      plane[byte] = static_cast<std::uint8_t>(set ? plane[byte] | bits : plane[byte] & ~bits);
    };
    if (first / 8 == end / 8) {
      change(first / 8, static_cast<std::uint8_t>(head & tail));
      continue;
    }
    change(first / 8, head);
    std::fill(plane + first / 8 + 1, plane + end / 8, static_cast<std::uint8_t>(set ? 0xFF : 0));
    if (tail != 0) change(end / 8, tail);
  }
}

void FrameBuffer::read_row(int column, int row, std::span<std::uint8_t> indices) const {
  require_on_screen(column, row, indices.size());
  std::size_t i = 0;
  for (; i < indices.size() && column % 8 != 0; ++i) indices[i] = read(column++, row);
  for (; i + 8 <= indices.size(); i += 8, column += 8) {
    const std::uint8_t* byte = &bits_[byte_offset(column, row)];
    std::uint64_t pixels = 0;
    for (int p = 0; p < kPlanes; ++p, byte += kPlaneBytes) pixels |= kPixelsOf[*byte] << p;
    for (std::size_t k = 0; k < 8; ++k)
      indices[i + k] = static_cast<std::uint8_t>(pixels >> (8 * k));
  }
  for (; i < indices.size(); ++i) indices[i] = read(column++, row);
}

std::span<const std::uint8_t> FrameBuffer::plane(int number) const {
  if (number < 0 || number >= kPlanes) throw std::out_of_range("the MA120 has planes 0 to 7");
  return std::span(bits_).subspan(static_cast<std::size_t>(number) * kPlaneBytes, kPlaneBytes);
}

}  // namespace sir::eltek
