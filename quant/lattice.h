// The lattice of the colours that a DAC can show (thesis 3.4: 64 x 64 x 64 on the MA120).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "quant/dac_code.h"
#include "tracer/planes.h"

namespace sir::quant {

/// The lattice of one DAC and the way to it from any colour. A point of the lattice is a
/// code e of each primary, seen as the byte round(255 e / (2^bits - 1)); different codes
/// are seen as different bytes. Points are chosen primary by primary, so the point nearest
/// in each is also the one of least squared distance in bytes.
class Lattice {
 public:
  /// Throws std::invalid_argument for other than 1 to 8 bits per primary.
  explicit Lattice(const DacBits& dac);

  /// The code whose byte as seen is nearest to the colour's byte, primary by primary; half
  /// way between two, the lower code. Since the bytes as seen are rounded, it is not always
  /// the code round((2^bits - 1) byte / 255): with 6 bits the byte 47 lies half way between
  /// 45 and 49, as which codes 11 and 12 are seen, and is 11.61 as a code.
  DacCode nearest(Rgb8 colour) const {
    return {(*codes_[0])[colour.r], (*codes_[1])[colour.g], (*codes_[2])[colour.b]};
  }

  /// The colour as which a point is seen.
  Rgb8 seen(const DacCode& code) const { return quant::seen(code, dac_); }

  const DacBits& dac() const { return dac_; }

 private:
  using Codes = std::array<std::uint8_t, 256>;  // of each byte
  DacBits dac_;
  std::array<const Codes*, 3> codes_;
};

/// Lattice(dac).nearest(colour).
DacCode nearest_code(Rgb8 colour, const DacBits& dac);

}  // namespace sir::quant
