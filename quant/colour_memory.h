// Answers given for colours, remembered.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quant/image_pair.h"
#include "tracer/planes.h"

namespace sir::quant {

/// The last answers, one for each hash of the colour. Renders and drawings repeat their colours,
/// so most pixels end here.
class ColourMemory {
 public:
  /// What was answered for the colour, else answer(colour).
  template <typename Answer>
  std::uint8_t operator()(Rgb8 colour, Answer& answer) {
    const std::uint32_t key = packed(colour);
    Slot& slot = slots_[key * 0x9E3779B1u >> (32 - kBits)];
    if (slot.colour != key) slot = {key, answer(colour)};
    return slot.index;
  }

 private:
  struct Slot {
    std::uint32_t colour = 0xFFFFFFFF;  // no colour of 24 bits
    std::uint8_t index = 0;
  };
  static constexpr int kBits = 14;
  std::vector<Slot> slots_{std::size_t{1} << kBits};
};

}  // namespace sir::quant
