#include "eltek/raster.h"

#include <algorithm>
#include <span>
#include <utility>

namespace sir::eltek {
namespace {

constexpr std::size_t kColumns = FrameBuffer::kColumns;

}  // namespace

Raster::Raster(const Ma120& machine) : machine_(&machine) { restart(); }

void Raster::restart() {
  position_.restart();
  tube_.indices.assign(Ma120::kSize.pixels(), 0);
  tube_.palettes.fill(std::make_shared<const Palette>());
}

void Raster::advance_to(int line) {
  const std::int64_t from = position_.scanned();
  position_.advance_to(line);
  const std::int64_t to = position_.scanned();
  // A pass over the frame at most: no line is scanned twice.
  const std::int64_t start = std::max(from, paint_from_);
  if (start >= to) return;
  const auto palette = palette_now();
  const std::int64_t frame = start / kTiming.lines * kTiming.lines;
  const auto in_frame = [](std::int64_t count) {
    return static_cast<int>(std::min<std::int64_t>(count, FrameBuffer::kRows));
  };
  scan(tube_, in_frame(start - frame), in_frame(to - frame), palette);
  if (to - frame > kTiming.lines) scan(tube_, 0, in_frame(to - frame - kTiming.lines), palette);
}

Screen Raster::tube() const { return seen(tube_); }

Screen Raster::frame() const { return seen(finished()); }

std::optional<IndexedScreen> Raster::capture() const {
  Tube tube = finished();
  const Palette& palette = *tube.palettes.front();
  for (const auto& other : tube.palettes)
    if (other != tube.palettes.front() && *other != palette) return std::nullopt;
  return IndexedScreen{Ma120::kSize, std::move(tube.indices), palette, machine_->dac()};
}

void Raster::scan(Tube& tube, int first, int end,
                  const std::shared_ptr<const Palette>& palette) const {
  const std::uint8_t mask = machine_->lut_ports.pixel_mask();
  for (int line = first; line < end; ++line) {
    const auto indices =
        std::span(tube.indices).subspan(static_cast<std::size_t>(line) * kColumns, kColumns);
    machine_->frame_buffer.read_row(0, line, indices);
    if (mask != 0xFF)
      for (std::uint8_t& index : indices) index &= mask;
    tube.palettes[static_cast<std::size_t>(line)] = palette;
  }
}

std::shared_ptr<const Raster::Palette> Raster::palette_now() const {
  return std::make_shared<const Palette>(machine_->blanked ? Palette{} : machine_->palette());
}

Raster::Tube Raster::finished() const {
  Tube tube = tube_;
  scan(tube, position_.line(), FrameBuffer::kRows, palette_now());
  return tube;
}

Screen Raster::seen(const Tube& tube) {
  Screen screen{Ma120::kSize, std::vector<Rgb8>(Ma120::kSize.pixels())};
  for (std::size_t line = 0; line < tube.palettes.size(); ++line) {
    const Palette& palette = *tube.palettes[line];
    for (std::size_t i = line * kColumns; i < (line + 1) * kColumns; ++i)
      screen.pixels[i] = palette[tube.indices[i]];
  }
  return screen;
}

}  // namespace sir::eltek
