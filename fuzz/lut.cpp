// The lookup table's file, BASE.LUT.
#include "quant/lut.h"
#include "fuzz/round_trip.h"
#include "fuzz/targets.h"

namespace sir::fuzz {

void play_lut(Bytes bytes) {
  const auto read = [](TextFile& file) { return quant::read_lut(file); };
  play_round_trip("F.LUT", bytes, read, quant::lut_text,
                  [](const quant::Lut& a, const quant::Lut& b) {
                    require(a.dac.valid() && a.chosen >= 1 && a.chosen <= quant::kLutEntries,
                            "a LUT that was read is one");
                    return a == b;
                  });
}

}  // namespace sir::fuzz
