// The lookup table of the MA120 behind its registers (thesis 3.4, 3.5).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "quant/lut.h"

namespace sir::eltek {

/// 256 entries of three 6-bit codes, reached through four ports as on the
/// RAMDACs of the time (Inmos IMS G171 and its VGA descendants). The thesis
/// says only that the display program initialises the table; the ports and
/// their order are our model:
///
///   write address  selects the entry that the next data bytes fill
///   read address   selects the entry that the next data bytes come from
///   data           R, G, B in turn
///   pixel mask     ANDed with every index on its way from the planes to the
///                  table ("read mask")
///
/// One address counter and one phase counter serve both directions. Writing
/// either address resets the phase, so an entry left half written keeps its
/// old codes. The third byte commits the entry and moves the address on by
/// one, from 255 to 0.
///
/// With another DAC fitted, a primary's codes have that DAC's bits.
class LutPorts {
 public:
  /// Throws std::invalid_argument for other than 1 to 8 bits per primary.
  explicit LutPorts(const quant::DacBits& dac = {});

  /// The DAC behind the table.
  const quant::DacBits& dac() const { return dac_; }

  void write_address(std::uint8_t address);
  void read_address(std::uint8_t address);

  /// Takes the next code of the turn R, G, B; only its low bits are wired, as
  /// many as the DAC has for that primary (on the MA120 6: 64 becomes 0).
  void write_data(std::uint8_t code);

  /// Gives the next code of the turn R, G, B.
  std::uint8_t read_data();

  void write_pixel_mask(std::uint8_t mask) { pixel_mask_ = mask; }
  std::uint8_t pixel_mask() const { return pixel_mask_; }

  /// The counter behind both addresses: the entry that data go to or come from next.
  std::uint8_t address() const { return address_; }

  /// The primary that data go to or come from next: 0, 1, 2 for R, G, B.
  std::size_t phase() const { return phase_; }

  /// What the scanout wires see: the entry chosen by a pixel's index under
  /// the pixel mask.
  const quant::DacCode& look_up(std::uint8_t index) const {
    return entries_[static_cast<std::uint8_t>(index & pixel_mask_)];
  }

 private:
  void advance();

  quant::DacBits dac_;
  std::array<quant::DacCode, quant::kLutEntries> entries_{};
  quant::DacCode latch_{};  // bytes that wait for the third
  std::uint8_t address_ = 0;
  std::size_t phase_ = 0;  // 0, 1, 2: R, G, B comes next
  std::uint8_t pixel_mask_ = 0xFF;
};

}  // namespace sir::eltek
