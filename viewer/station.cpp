#include "viewer/station.h"

#include <cstddef>
#include <span>

namespace sir::viewer {

void Station::show(const std::string& name, ImageSize size, const Rendition& rendition) {
  const auto oversize = image_area_only_ ? eltek::Oversize::crop : eltek::Oversize::refuse;
  const eltek::Placement placement = eltek::place(name, size, oversize);
  if (monitor_.dac() != rendition.lut.dac) bus_.power_cycle(rendition.lut.dac);
  eltek::show_image(bus_, {name, size, rendition.indices}, rendition.lut, oversize,
                    rendition.reserved);
  placement_ = placement;
  seen_area_ = image_area_only_ ? placement.on_screen : eltek::Area{0, 0, eltek::Ma120::kSize};
  if (planes_ != 0xFF) bus_.write(eltek::Port::pixel_mask, planes_);
}

void Station::set_planes(std::uint8_t mask) {
  if (mask == planes_) return;
  planes_ = mask;
  bus_.write(eltek::Port::pixel_mask, mask);
}

std::optional<Place> Station::image_pixel(Place seen) const {
  const eltek::Area& area = placement_.on_screen;
  const Place within{seen.x + seen_area_.column - area.column, seen.y + seen_area_.row - area.row};
  if (within.x < 0 || within.y < 0 || within.x >= area.size.width || within.y >= area.size.height)
    return std::nullopt;
  return Place{within.x + placement_.image_column, within.y + placement_.image_row};
}

std::optional<Place> Station::seen_pixel(Place image) const {
  const eltek::Area& area = placement_.on_screen;
  const Place within{image.x - placement_.image_column, image.y - placement_.image_row};
  if (within.x < 0 || within.y < 0 || within.x >= area.size.width || within.y >= area.size.height)
    return std::nullopt;
  return Place{within.x + area.column - seen_area_.column, within.y + area.row - seen_area_.row};
}

IndexWords Station::seen_words(const eltek::Crt* crt) const {
  std::array<Rgb8, 256> seen = monitor_.seen();
  if (crt != nullptr) seen = crt->palette(seen, monitor_.dac());
  IndexWords words;
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = argb(seen[i]);
  return words;
}

void Station::scan_out(Frame& frame, const IndexWords& words, const Columns& columns) const {
  eltek::Area area = seen_area_;
  area.column += columns.first;
  area.size.width = columns.end - columns.first;
  if (area.size.width > 0)
    monitor_.scan_out_words(area, words,
                            std::span(frame.words).subspan(frame.offset(columns.first, 0)),
                            static_cast<std::size_t>(frame.size.width));
}

}  // namespace sir::viewer
