// What showing an image puts on the bus, and how long that takes (thesis 3.5, on a bus whose
// width and rate are our model).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "eltek/bus_listener.h"
#include "eltek/frame_timing.h"

namespace sir::eltek {

/// Counts what passes on a bus of 8 bits, at which each access takes bus_bytes(port) bytes.
class BusTally : public BusListener {
 public:
  void wrote(Port port, std::uint16_t) override { add(port, 1); }
  void read(Port port, std::uint16_t) override { add(port, 1); }
  void wrote_pixels(std::span<const std::uint8_t> indices) override {
    add(Port::pixel, indices.size());
  }
  void filled_pixels(std::uint8_t, std::size_t count) override { add(Port::pixel, count); }
  void read_pixels(std::span<const std::uint8_t> indices) override {
    add(Port::pixel, indices.size());
  }

  /// Bytes to and from one register.
  std::uint64_t bytes(Port port) const { return bytes_[static_cast<std::size_t>(port)]; }

  /// Bytes in all.
  std::uint64_t bytes() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t one : bytes_) sum += one;
    return sum;
  }

 private:
  void add(Port port, std::size_t accesses) {
    bytes_[static_cast<std::size_t>(port)] +=
        accesses * static_cast<std::uint64_t>(bus_bytes(port));
  }

  std::array<std::uint64_t, kPorts.size()> bytes_{};
};

/// How long a bus of `rate` bytes a second, > 0, takes for so many bytes.
struct Transfer {
  std::uint64_t bytes = 0;
  double rate = 0;

  double seconds() const { return static_cast<double>(bytes) / rate; }

  /// The same in frames of the MA120.
  double frames() const { return seconds() / kTiming.frame_seconds(); }
};

}  // namespace sir::eltek
