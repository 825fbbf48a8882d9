#include "eltek/lut_ports.h"

#include <stdexcept>

namespace sir::eltek {

LutPorts::LutPorts(const quant::DacBits& dac) : dac_(dac) {
  if (!dac.valid()) throw std::invalid_argument("a DAC of other than 1 to 8 bits per primary");
}

void LutPorts::write_address(std::uint8_t address) {
  address_ = address;
  phase_ = 0;
}

void LutPorts::read_address(std::uint8_t address) {
  address_ = address;
  phase_ = 0;
}

void LutPorts::write_data(std::uint8_t code) {
  latch_[phase_] = static_cast<std::uint8_t>(code & dac_.max_code(phase_));
  if (phase_ == 2) entries_[address_] = latch_;
  advance();
}

std::uint8_t LutPorts::read_data() {
  const std::uint8_t code = entries_[address_][phase_];
  advance();
  return code;
}

void LutPorts::advance() {
  if (++phase_ < 3) return;
  phase_ = 0;
  ++address_;  // an 8-bit counter: 255 is followed by 0
}

}  // namespace sir::eltek
