#include "quant/histogram.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace sir::quant {
namespace {

constexpr std::size_t kBlock = 1024;  // pixels at a time: buffers stay in the first-level cache

/// The pixels of one block, those between the sampled ones left out.
class Sample {
 public:
  Sample(const Planes& image, std::size_t every) : image_(image), every_(every) {}

  std::size_t size() const { return (image_.size.pixels() + every_ - 1) / every_; }

  /// Channel c of the sampled pixels first, first + 1... first + count - 1.
  const std::uint8_t* channel(std::size_t c, std::size_t first, std::size_t count) {
    const std::uint8_t* const plane = image_.channel[c].data();
    if (every_ == 1) return plane + first;
    for (std::size_t i = 0; i < count; ++i) buffer_[c][i] = plane[(first + i) * every_];
    return buffer_[c].data();
  }

 private:
  const Planes& image_;
  std::size_t every_;
  std::array<std::array<std::uint8_t, kBlock>, 3> buffer_;
};

}  // namespace

Histogram count_cells(const Planes& image, const Grid& grid, std::size_t every) {
  if (every == 0) throw std::invalid_argument("a sample of every 0th pixel");
  std::vector<std::uint64_t> pixels(grid.size());
  std::array<std::uint32_t, kBlock> cells;
  Sample sample(image, every);
  for (std::size_t first = 0; first < sample.size(); first += kBlock) {
    const std::span block(cells.data(), std::min(kBlock, sample.size() - first));
    grid.locate(sample.channel(0, first, block.size()), sample.channel(1, first, block.size()),
                sample.channel(2, first, block.size()), block);
    for (const std::uint32_t cell : block) ++pixels[cell];
  }
  Histogram occupied;
  for (std::size_t cell = 0; cell < pixels.size(); ++cell)
    if (pixels[cell] > 0) occupied.push_back({grid.point(cell), pixels[cell]});
  return occupied;
}

}  // namespace sir::quant
