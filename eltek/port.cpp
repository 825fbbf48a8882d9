#include "eltek/port.h"

#include "eltek/pixel_address.h"

namespace sir::eltek {

std::string_view name(Port port) {
  switch (port) {
    case Port::lut_write: return "lut.write";
    case Port::lut_read: return "lut.read";
    case Port::lut_data: return "lut.data";
    case Port::pixel_mask: return "mask";
    case Port::plane_mask: return "planes";
    case Port::column: return "column";
    case Port::row: return "row";
    case Port::pixel: return "pixel";
    case Port::blank: return "blank";
  }
  return "";
}

int largest(Port port) {
  switch (port) {
    case Port::column:
    case Port::row: return (1 << PixelAddress::kBits) - 1;
    case Port::blank: return 1;
    default: return 0xFF;
  }
}

int bus_bytes(Port port) { return largest(port) > 0xFF ? 2 : 1; }

}  // namespace sir::eltek
