// The MA120 behind its registers, as the host sees it (thesis 3.5, whose program initialises the
// LUT and sends indices; the registers are our model).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "eltek/bus_listener.h"
#include "eltek/ma120.h"
#include "eltek/port.h"
#include "eltek/raster.h"

namespace sir::eltek {

/// Everything that a program does to the machine passes here, and listeners hear of it. The bus
/// refers to the machine, to the raster where there is one, and to the listeners; they outlive it.
class Bus {
 public:
  /// A raster, if given, is of this machine.
  explicit Bus(Ma120& machine, Raster* raster = nullptr) : machine_(machine), raster_(raster) {}

  /// Writes a register. As many low bits as it has are wired: 256 to a register of 8 bits is 0.
  void write(Port port, std::uint16_t value);

  /// Reads a register: what it holds. LUT data and pixels come from where the addresses point,
  /// which then move on as for a write; both LUT addresses read as the one counter behind them.
  std::uint16_t read(Port port);

  /// Pixel after pixel to the pixel register, as a string instruction sends them.
  void write_pixels(std::span<const std::uint8_t> indices);

  /// The same index so many times.
  void fill_pixels(std::uint8_t index, std::size_t count);

  /// Pixel after pixel from the pixel register.
  void read_pixels(std::span<std::uint8_t> indices);

  /// The host waits until the raster stands at a line (Raster::advance_to, which says what it
  /// throws). Without a raster only the listeners learn of it.
  void wait(int line);

  /// Switches the machine off and on, with another DAC fitted: memory, registers and screen are
  /// as at the first power-on. Throws std::invalid_argument for a DAC that cannot be.
  void power_cycle(const quant::DacBits& dac);

  void add_listener(BusListener& listener) { listeners_.push_back(&listener); }

  const Ma120& machine() const { return machine_; }

 private:
  template <typename Event>
  void tell(const Event& event) {
    for (BusListener* listener : listeners_) event(*listener);
  }

  Ma120& machine_;
  Raster* raster_;
  std::vector<BusListener*> listeners_;
};

}  // namespace sir::eltek
