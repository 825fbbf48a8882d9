#include "tests/ma120_model.h"

#include <cmath>
#include <utility>

namespace sir::test {

using eltek::Port;
using eltek::Screen;

PlainMa120::PlainMa120(const quant::DacBits& dac)
    : dac_(dac),
      pixels_(kWidth * kHeight),
      tube_{{kWidth, kHeight}, std::vector<Rgb8>(kWidth * kHeight)} {}

void PlainMa120::write(Port port, int value) {
  switch (port) {
    case Port::lut_write:
    case Port::lut_read:
      address_ = value % 256;
      phase_ = 0;
      break;
    case Port::lut_data:
      waiting_[phase_] = value % (1 << dac_.bits[static_cast<std::size_t>(phase_)]);
      if (++phase_ == 3) {
        for (int i = 0; i < 3; ++i) lut_[address_][i] = waiting_[i];
        phase_ = 0;
        address_ = (address_ + 1) % 256;
      }
      break;
    case Port::pixel_mask: mask_ = value % 256; break;
    case Port::plane_mask: planes_ = value % 256; break;
    case Port::column: column_ = value % 1024; break;
    case Port::row: row_ = value % 1024; break;
    case Port::pixel:
      if (row_ < kHeight) {
        std::uint8_t& pixel = pixels_[static_cast<std::size_t>(row_ * kWidth + column_)];
        pixel = static_cast<std::uint8_t>((pixel & ~planes_) | (value & planes_));
      }
      advance_pixel();
      break;
    case Port::blank: blank_ = value % 2 == 1; break;
  }
}

int PlainMa120::read(Port port) {
  int value = 0;
  switch (port) {
    case Port::lut_write:
    case Port::lut_read: return address_;
    case Port::lut_data:
      value = lut_[address_][phase_];
      if (++phase_ == 3) {
        phase_ = 0;
        address_ = (address_ + 1) % 256;
      }
      return value;
    case Port::pixel_mask: return mask_;
    case Port::plane_mask: return planes_;
    case Port::column: return column_;
    case Port::row: return row_;
    case Port::pixel:
      if (row_ < kHeight) value = pixels_[static_cast<std::size_t>(row_ * kWidth + column_)];
      advance_pixel();
      return value;
    case Port::blank: return blank_ ? 1 : 0;
  }
  return 0;
}

void PlainMa120::advance_pixel() {
  if (++column_ < kWidth) return;
  column_ = 0;
  ++row_;
  if (row_ == kHeight || row_ == 1024) row_ = 0;
}

void PlainMa120::wait(int line) {
  while (line_ != line) {
    if (line_ < kHeight)
      for (int column = 0; column < kWidth; ++column)
        tube_.pixels[static_cast<std::size_t>(line_ * kWidth + column)] = colour(column, line_);
    line_ = (line_ + 1) % kLines;
  }
}

void PlainMa120::power(const quant::DacBits& dac) { *this = PlainMa120(dac); }

Rgb8 PlainMa120::colour(int column, int row) const {
  if (blank_) return {};
  const int index = pixels_[static_cast<std::size_t>(row * kWidth + column)] & mask_;
  std::uint8_t seen[3];
  for (std::size_t i = 0; i < 3; ++i)
    seen[i] = static_cast<std::uint8_t>(
        std::floor(255.0 * lut_[index][i] / ((1 << dac_.bits[i]) - 1) + 0.5));
  return {seen[0], seen[1], seen[2]};
}

Screen PlainMa120::scan() const {
  Screen screen = tube_;
  for (int row = 0; row < kHeight; ++row)
    for (int column = 0; column < kWidth; ++column)
      screen.pixels[static_cast<std::size_t>(row * kWidth + column)] = colour(column, row);
  return screen;
}

Screen PlainMa120::frame() const {
  PlainMa120 later = *this;
  if (later.line_ < kHeight) later.wait(kHeight);
  return std::move(later.tube_);
}

}  // namespace sir::test
