#include "eltek/ma120.h"

#include <algorithm>
#include <stdexcept>

#include "eltek/dac.h"

namespace sir::eltek {

void Ma120::scan_line(int row, std::span<Rgb8, FrameBuffer::kColumns> line) const {
  std::array<std::uint8_t, FrameBuffer::kColumns> indices;
  frame_buffer.read_row(0, row, indices);
  if (blanked) {
    std::fill(line.begin(), line.end(), Rgb8{});
    return;
  }
  for (std::size_t i = 0; i < indices.size(); ++i)
    line[i] = dac_colour(lut_ports.look_up(indices[i]), dac());
}

Screen Ma120::scan_out() const {
  Screen screen{kSize, std::vector<Rgb8>(kSize.pixels())};
  for (int row = 0; row < kSize.height; ++row)
    scan_line(row, std::span<Rgb8, FrameBuffer::kColumns>(&screen.pixels[screen.offset(0, row)],
                                                          FrameBuffer::kColumns));
  return screen;
}

std::array<Rgb8, 256> Ma120::seen() const {
  std::array<Rgb8, 256> colours{};
  if (blanked) return colours;
  for (std::size_t i = 0; i < colours.size(); ++i)
    colours[i] = dac_colour(lut_ports.look_up(static_cast<std::uint8_t>(i)), dac());
  return colours;
}

void Ma120::scan_out_words(const Area& area, std::span<const std::uint32_t, 256> words_of,
                           std::span<std::uint32_t> words, std::size_t stride) const {
  if (area.size.width < 0 || area.size.width > kSize.width || area.size.height < 0)
    throw std::out_of_range("an area that leaves the MA120's screen");
  const auto width = static_cast<std::size_t>(area.size.width);
  const auto height = static_cast<std::size_t>(area.size.height);
  if (width == 0 || height == 0) return;
  if (stride < width || words.size() < (height - 1) * stride + width)
    throw std::invalid_argument("no room for the MA120's screen");
  std::array<std::uint8_t, FrameBuffer::kColumns> memory;
  const std::span<std::uint8_t> indices = std::span(memory).first(width);
  for (std::size_t row = 0; row < height; ++row) {
    frame_buffer.read_row(area.column, area.row + static_cast<int>(row), indices);
    std::uint32_t* const line = &words[row * stride];
    // Bare, the loop is a third slower where it happens to lie across two lines of the cache.
#pragma GCC unroll 4
    for (std::size_t i = 0; i < width; ++i) line[i] = words_of[indices[i]];
  }
}

IndexedScreen Ma120::capture() const {
  IndexedScreen screen{kSize, std::vector<std::uint8_t>(kSize.pixels()), {}, dac()};
  if (!blanked) screen.palette = palette();
  for (int row = 0; row < kSize.height; ++row)
    frame_buffer.read_row(
        0, row,
        std::span(screen.indices)
            .subspan(static_cast<std::size_t>(row) * FrameBuffer::kColumns, FrameBuffer::kColumns));
  for (auto& index : screen.indices) index &= lut_ports.pixel_mask();
  return screen;
}

std::array<Rgb8, 256> Ma120::palette() const {
  // Read past the mask, on a copy: reading through the ports moves them.
  LutPorts ports = lut_ports;
  ports.write_pixel_mask(0xFF);
  std::array<Rgb8, 256> colours;
  for (std::size_t i = 0; i < colours.size(); ++i)
    colours[i] = dac_colour(ports.look_up(static_cast<std::uint8_t>(i)), dac());
  return colours;
}

}  // namespace sir::eltek
