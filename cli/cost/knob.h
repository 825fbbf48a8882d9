// The knobs of the price list: what a person can turn for time or accuracy (thesis 2.4, 3.4, 4.4).
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

namespace sir::cli {

enum class Knob : std::uint8_t {
  precision,  ///< float, double, long double
  formulas,   ///< robust or textbook
  depth,      ///< of the tree of rays
  cutoff,     ///< least weight of a secondary ray
  antialias,  ///< rays a pixel
  preview,    ///< blocks of pixels
  combined,   ///< several knobs at once; of the tracer and of the LUT
  method,     ///< of choosing a LUT, with the order of splitting
  grid,       ///< in which colours are counted, with the limits of grey
  sample,     ///< every so many-th pixel counted
  nearest,    ///< how the nearest entry is found
  effort,     ///< of the method best, for either of its goals
  map,        ///< what "nearest" means: by the bytes or by the eye
  dither      ///< entries side by side
};

/// Its word on the command line.
const char* name_of(Knob knob);

/// All words, with a space between.
std::string known_knobs();

/// Knobs that are asked for; an empty set stands for all.
using KnobSet = std::set<Knob>;
bool wants(const KnobSet& only, Knob knob);
bool wants_tracer(const KnobSet& only);
bool wants_lut(const KnobSet& only);

/// Reads words with a comma between. False, and `knobs` as it was, where one is
/// unknown or there is none.
bool parse_knobs(std::string_view text, KnobSet& knobs);

}  // namespace sir::cli
