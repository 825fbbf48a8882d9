#include "quant/best_places.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace sir::quant {
namespace {

[[noreturn]] void refuse(const std::string& reason) { throw std::invalid_argument(reason); }

void check_code(const Pin& pin, const DacBits& dac) {
  for (std::size_t c = 0; c < 3; ++c)
    if (pin.code[c] > dac.max_code(c))
      refuse("pin " + pin_text(pin) + " is no code: the DAC's go from 0 to " +
             std::to_string(dac.max_code(0)) + "," + std::to_string(dac.max_code(1)) + "," +
             std::to_string(dac.max_code(2)));
}

}  // namespace

Places places_of(const BestOptions& options) {
  if (!options.dac.valid()) refuse("a DAC has 1 to 8 bits per primary");
  if (options.entries < 1 || options.entries > kLutEntries)
    refuse(std::to_string(options.entries) + " entries: a LUT has 1 to 256");
  const std::size_t usable = kLutEntries - options.reserved.count();
  if (options.entries > usable)
    refuse(std::to_string(options.entries) + " entries, but only " + std::to_string(usable) +
           " indices are not reserved");
  if (options.pins.size() > options.entries)
    refuse(std::to_string(options.pins.size()) + " pins are too many for " +
           std::to_string(options.entries) + (options.entries == 1 ? " entry" : " entries"));

  IndexSet taken = options.reserved;
  for (const Pin& pin : options.pins) {
    check_code(pin, options.dac);
    if (!pin.index) continue;
    if (*pin.index >= kLutEntries) refuse("pin " + pin_text(pin) + " is at no index from 0 to 255");
    if (options.reserved[*pin.index]) refuse("pin " + pin_text(pin) + " is at a reserved index");
    if (taken[*pin.index]) refuse("pin " + pin_text(pin) + " is the second at its index");
    taken.set(*pin.index);
  }
  Places places;
  std::size_t next = 0;
  const auto take_next = [&] {
    while (taken[next]) ++next;
    taken.set(next);
    return next;
  };
  for (const Pin& pin : options.pins) places.pinned.push_back(pin.index ? *pin.index : take_next());
  while (places.free.size() + options.pins.size() < options.entries)
    places.free.push_back(take_next());
  return places;
}

Lut placed(std::span<const DacCode> codes, const Places& places, const BestOptions& options) {
  Lut lut;
  lut.dac = options.dac;
  IndexSet used;
  const auto put = [&](std::size_t index, const DacCode& code) {
    lut.entry[index] = code;
    used.set(index);
  };
  for (std::size_t i = 0; i < codes.size(); ++i)
    put(i < places.pinned.size() ? places.pinned[i] : places.free[i - places.pinned.size()],
        codes[i]);
  DacCode before = codes.front();
  for (std::size_t i = 0; i < kLutEntries; ++i) {
    if (used[i]) {
      before = lut.entry[i];
      lut.chosen = i + 1;
    } else if (options.reserved[i]) {
      lut.entry[i] = options.from ? options.from->entry[i] : DacCode{};
    } else {
      lut.entry[i] = before;
    }
  }
  return lut;
}

}  // namespace sir::quant
