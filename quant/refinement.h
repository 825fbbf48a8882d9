// How long a palette is worked on: the efforts of the method `best`.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

#include "quant/palette.h"

namespace sir::quant {

inline constexpr int kMinEffort = 1, kUsualEffort = 3, kMaxEffort = 5;

/// Told now and then the share that is done, in [0,1]; may be empty.
using ProgressTo = std::function<void(double)>;

/// The steps of quant/palette.h in their order, each until it gains little or the effort is spent.
/// A stop request ends it after the step that runs.
class Refinement {
 public:
  /// `effort` from kMinEffort to kMaxEffort, else std::invalid_argument.
  Refinement(int effort, ProgressTo progress, std::stop_token stop);

  /// So many points at most are worth their time: beyond, colours are taken together.
  std::size_t points() const;

  /// Off the lattice: entries without colours spent, Lloyd's steps, swaps, steps again.
  void free(Palette& palette);

  /// The same on the lattice, where swaps belong to the greater efforts, then nudges.
  void held(Palette& palette);

 private:
  struct Effort;
  static const Effort kEfforts[];

  bool stopped() const { return stop_.stop_requested(); }
  void tell(double done);
  void lloyd(Palette& palette);
  void swaps(Palette& palette);
  void spend_spare(Palette& palette);
  void fill(Palette& palette);

  const Effort& effort_;
  ProgressTo progress_;
  std::stop_token stop_;
  double done_ = 0;
};

}  // namespace sir::quant
