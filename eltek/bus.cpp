#include "eltek/bus.h"

#include <algorithm>
#include <stdexcept>

namespace sir::eltek {
namespace {

// Calls part(n) for pieces of neighbouring pixels within a row, none longer than what is left.
template <typename Part>
void in_rows(PixelAddress& address, std::size_t count, const Part& part) {
  while (count > 0) {
    const std::size_t room = static_cast<std::size_t>(FrameBuffer::kColumns - address.column());
    const std::size_t length = std::min(count, room);
    part(length);
    address.advance(length);
    count -= length;
  }
}

}  // namespace

void Bus::write(Port port, std::uint16_t value) {
  value = static_cast<std::uint16_t>(value & largest(port));
  const auto byte = static_cast<std::uint8_t>(value);
  switch (port) {
    case Port::lut_write: machine_.lut_ports.write_address(byte); break;
    case Port::lut_read: machine_.lut_ports.read_address(byte); break;
    case Port::lut_data: machine_.lut_ports.write_data(byte); break;
    case Port::pixel_mask: machine_.lut_ports.write_pixel_mask(byte); break;
    case Port::plane_mask: machine_.frame_buffer.set_write_mask(byte); break;
    case Port::column: machine_.pixel_address.set_column(value); break;
    case Port::row: machine_.pixel_address.set_row(value); break;
    case Port::pixel: write_pixels({&byte, 1}); return;
    case Port::blank: machine_.blanked = value != 0; break;
  }
  tell([&](BusListener& listener) { listener.wrote(port, value); });
}

std::uint16_t Bus::read(Port port) {
  std::uint16_t value = 0;
  switch (port) {
    case Port::lut_write:
    case Port::lut_read: value = machine_.lut_ports.address(); break;
    case Port::lut_data: value = machine_.lut_ports.read_data(); break;
    case Port::pixel_mask: value = machine_.lut_ports.pixel_mask(); break;
    case Port::plane_mask: value = machine_.frame_buffer.write_mask(); break;
    case Port::column: value = static_cast<std::uint16_t>(machine_.pixel_address.column()); break;
    case Port::row: value = static_cast<std::uint16_t>(machine_.pixel_address.row()); break;
    case Port::pixel: {
      std::uint8_t index = 0;
      read_pixels({&index, 1});
      return index;
    }
    case Port::blank: value = machine_.blanked ? 1 : 0; break;
  }
  tell([&](BusListener& listener) { listener.read(port, value); });
  return value;
}

void Bus::write_pixels(std::span<const std::uint8_t> indices) {
  PixelAddress& address = machine_.pixel_address;
  auto rest = indices;
  in_rows(address, indices.size(), [&](std::size_t length) {
    if (address.on_screen())
      machine_.frame_buffer.write_row(address.column(), address.row(), rest.first(length));
    rest = rest.subspan(length);
  });
  tell([&](BusListener& listener) { listener.wrote_pixels(indices); });
}

void Bus::fill_pixels(std::uint8_t index, std::size_t count) {
  PixelAddress& address = machine_.pixel_address;
  for (std::size_t rest = count; rest > 0;) {
    const std::size_t length = std::min(rest, address.before_wrap());
    if (address.on_screen())
      machine_.frame_buffer.fill(address.column(), address.row(), length, index);
    address.advance(length);
    rest -= length;
  }
  tell([&](BusListener& listener) { listener.filled_pixels(index, count); });
}

void Bus::read_pixels(std::span<std::uint8_t> indices) {
  PixelAddress& address = machine_.pixel_address;
  auto rest = indices;
  in_rows(address, indices.size(), [&](std::size_t length) {
    if (address.on_screen())
      machine_.frame_buffer.read_row(address.column(), address.row(), rest.first(length));
    else std::fill_n(rest.begin(), length, std::uint8_t{0});
    rest = rest.subspan(length);
  });
  tell([&](BusListener& listener) { listener.read_pixels(indices); });
}

void Bus::wait(int line) {
  if (raster_ != nullptr) raster_->advance_to(line);
  else require_line(line);
  tell([&](BusListener& listener) { listener.waited(line); });
}

void Bus::power_cycle(const quant::DacBits& dac) {
  machine_ = Ma120(dac);
  if (raster_ != nullptr) raster_->restart();
  tell([&](BusListener& listener) { listener.power_cycled(dac); });
}

}  // namespace sir::eltek
