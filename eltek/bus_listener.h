// What happens on the bus between host and MA120, told to whoever records or counts it (our
// model; the thesis has no such thing).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "eltek/port.h"
#include "quant/dac_code.h"

namespace sir::eltek {

/// Told after the machine has acted. Values are as the register took or gave them: low bits alone.
class BusListener {
 public:
  virtual ~BusListener() = default;

  virtual void wrote(Port, std::uint16_t /*value*/) {}
  virtual void read(Port, std::uint16_t /*value*/) {}
  virtual void wrote_pixels(std::span<const std::uint8_t>) {}
  virtual void filled_pixels(std::uint8_t /*index*/, std::size_t /*count*/) {}
  virtual void read_pixels(std::span<const std::uint8_t>) {}
  virtual void waited(int /*line*/) {}
  virtual void power_cycled(const quant::DacBits&) {}
};

}  // namespace sir::eltek
