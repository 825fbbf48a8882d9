// Times of repeated runs that take turns, and what they say together.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace sir::cli {

/// The middle of some measurements, and how far apart their middle half lies.
struct Spread {
  double median = 0, low = 0, high = 0;  ///< low, high: quartiles
  std::size_t runs = 0;
};

/// Quartiles between neighbours by linear interpolation (Hyndman and Fan's
/// seventh); all zero where there are no values.
Spread spread_of(std::span<const double> values);

/// `times` over `base` of the same round, for the rounds in which both ran.
Spread ratio_of(std::span<const double> times, std::span<const double> base);

/// Lets rows run in rounds. Each round begins with another row: a round is as
/// long as a scheduler's turn, which would otherwise always end in the same row.
/// Every row runs in the first round; after it, row i only while it has run
/// less often than `runs_of(i)` says.
class Rounds {
 public:
  /// `run(row)` returns false where the work was interrupted.
  using Run = std::function<bool(std::size_t row)>;
  using RunsOf = std::function<std::size_t(std::size_t row)>;

  Rounds(std::size_t rows, std::size_t repeats) : rows_(rows), repeats_(repeats) {}

  /// False where it was interrupted.
  bool operator()(const Run& run, const RunsOf& runs_of = {}) const;

 private:
  std::size_t rows_, repeats_;
};

/// How often a row should run that took `ms`, where the default takes `base`:
/// `repeats` times up to ten times the default's time; above, as often as the
/// same total time allows, but twice.
std::size_t affordable_runs(double ms, double base, std::size_t repeats);

}  // namespace sir::cli
