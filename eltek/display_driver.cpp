#include "eltek/display_driver.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "quant/dac_parse.h"
#include "quant/nearest.h"
#include "tracer/error.h"

namespace sir::eltek {
namespace {

std::string text(ImageSize size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

void require_same(const quant::DacBits& of_lut, const quant::DacBits& fitted) {
  if (of_lut != fitted)
    throw std::invalid_argument("a LUT for a DAC of " + quant::bits_text(of_lut) +
                                " bits; the one fitted has " + quant::bits_text(fitted));
}

}  // namespace

Placement place(const std::string& name, ImageSize image, Oversize oversize) {
  if (image.width < 1 || image.height < 1)
    throw FileError(name, 0, "an image of " + text(image) + " has no pixels to show");
  const ImageSize part{std::min(image.width, Ma120::kSize.width),
                       std::min(image.height, Ma120::kSize.height)};
  if (part != image && oversize == Oversize::refuse)
    throw FileError(name, 0,
                    "an image of " + text(image) + " is larger than the MA120's screen of " +
                        text(Ma120::kSize) + "; --crop shows the part at its centre");
  const Area on_screen{(Ma120::kSize.width - part.width) / 2,
                       (Ma120::kSize.height - part.height) / 2, part};
  return {on_screen, (image.width - part.width) / 2, (image.height - part.height) / 2};
}

void load_lut(Bus& bus, const quant::Lut& lut) {
  require_same(lut.dac, bus.machine().dac());
  bus.write(Port::lut_write, 0);
  for (const quant::DacCode& entry : lut.entry)
    for (const std::uint8_t code : entry) bus.write(Port::lut_data, code);
}

std::uint8_t nearest_to_black(const quant::Lut& lut, const quant::IndexSet& reserved) {
  return quant::nearest_entry(Rgb8{0, 0, 0}, lut, reserved);
}

Area show_image(Bus& bus, const IndexedImage& image, const quant::Lut& lut, Oversize oversize,
                const quant::IndexSet& reserved) {
  const Placement placement = place(image.name, image.size, oversize);
  if (image.indices.size() != image.size.pixels())
    throw std::invalid_argument("an image has one index for every pixel");
  const std::uint8_t border = nearest_to_black(lut, reserved);
  load_lut(bus, lut);
  bus.write(Port::pixel_mask, 0xFF);
  bus.write(Port::plane_mask, 0xFF);
  bus.write(Port::blank, 0);
  bus.write(Port::column, 0);
  bus.write(Port::row, 0);

  const Area& area = placement.on_screen;
  std::array<std::uint8_t, FrameBuffer::kColumns> row;
  for (int j = 0; j < FrameBuffer::kRows; ++j) {
    row.fill(border);
    if (j >= area.row && j < area.row + area.size.height) {
      const int image_row = placement.image_row + j - area.row;
      const auto first = image.indices.begin() + std::ptrdiff_t{image_row} * image.size.width +
                         placement.image_column;
      std::copy_n(first, area.size.width, row.begin() + area.column);
    }
    bus.write_pixels(row);  // the address moves on to the next row by itself
  }
  return area;
}

Area show_image(Ma120& monitor, const IndexedImage& image, const quant::Lut& lut, Oversize oversize,
                const quant::IndexSet& reserved) {
  Bus bus(monitor);
  return show_image(bus, image, lut, oversize, reserved);
}

}  // namespace sir::eltek
