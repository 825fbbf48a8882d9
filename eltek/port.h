// The registers of the MA120, as a host addresses them (our model, after the RAMDACs and planar
// boards of the time; thesis 3.5 says only what is sent).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace sir::eltek {

enum class Port : std::uint8_t {
  lut_write,   ///< entry that the next LUT data fill
  lut_read,    ///< entry that the next LUT data come from
  lut_data,    ///< r, g, b in turn (LutPorts)
  pixel_mask,  ///< ANDed with every index on its way to the LUT ("read mask")
  plane_mask,  ///< planes that written pixels reach
  column,      ///< of the next pixel
  row,         ///< of the next pixel
  pixel,       ///< index at (column, row), which then move on (PixelAddress)
  blank        ///< 1: the screen is black, 0: it is not
};

inline constexpr std::array kPorts{Port::lut_write,  Port::lut_read,   Port::lut_data,
                                   Port::pixel_mask, Port::plane_mask, Port::column,
                                   Port::row,        Port::pixel,      Port::blank};

/// As a trace writes it: "lut.write", "lut.read", "lut.data", "mask", "planes", "column", "row",
/// "pixel", "blank".
std::string_view name(Port port);

/// The largest value that a register takes: 255, 1023 for column and row, 1 for blank.
int largest(Port port);

/// Bytes that one access puts on the bus: 1, for the 10-bit registers 2.
int bus_bytes(Port port);

}  // namespace sir::eltek
