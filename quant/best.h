// The method `best`: entries chosen on the DAC's own lattice, by the eye or by the bytes. Beyond
// the thesis, whose methods (3.4) choose in grids and round to the lattice at the end.
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "quant/colour_measure.h"
#include "quant/colour_points.h"
#include "quant/dac_code.h"
#include "quant/index_set.h"
#include "quant/lut.h"
#include "quant/pin.h"
#include "quant/refinement.h"

namespace sir::quant {

struct BestOptions {
  Goal goal = Goal::perceptual;
  int effort = kUsualEffort;  ///< kMinEffort, in a hurry, to kMaxEffort, to the last gain
  DacBits dac;
  std::size_t entries = kLutEntries;  ///< at most so many are used, the pins among them
  std::vector<Pin> pins;
  IndexSet reserved;          ///< left to others
  bool protect_hues = false;  ///< see guard_hues
  /// Start from these entries: each keeps its index and moves no farther than it must. None: the
  /// entries are ordered from dark to light.
  std::optional<Lut> from;
};

struct BestChoice {
  Lut lut;
  std::size_t entries = 0;  ///< in use, the pins among them
  /// Root of the mean squared difference of a pixel and its entry, by ColourMeasure: of CIEDE2000
  /// its local form, which far from the entries is often less than CIEDE2000 itself. At most:
  /// colours taken together count as going to one entry.
  double error = 0;
  std::vector<int> lost_hues;  ///< planes that protect_hues could not give an entry
};

/// Chooses entries for the colours in these steps, a greater effort taking more of each:
/// 1. groups by splits along principal axes (quant/principal_split.h);
/// 2. Lloyd's steps and swaps of entries, free of the lattice;
/// 3. the entries moved onto the lattice, Lloyd's steps there, then nudges (quant/palette.h).
/// Where the colours' nearest codes are no more than the entries, they are the start of 3, so that
/// such a picture is shown as well as the DAC can. A stop request ends it early, with what is
/// reached by then.
///
/// An index that is not used repeats an entry before it, or where there is none, pins being all
/// there is, the first pin; a reserved one has `from`'s entry, else
/// black. The same input gives the same LUT; no threads are started. Throws std::invalid_argument
/// with a message for people: entries of 0 or more than 256 or than are not reserved, more pins
/// than entries, pins that are no codes of the DAC, twice at an index or at a reserved one, a
/// `from` of another DAC, an effort out of range, and no colours.
BestChoice choose_best(const WeightedColours& colours, const BestOptions& options = {},
                       const ProgressTo& progress = {}, std::stop_token stop = {});

}  // namespace sir::quant
