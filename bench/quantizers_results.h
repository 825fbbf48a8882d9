// What `quantizers` has measured, and what it should come to.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/quantizers_judge.h"

namespace sir::bench {

/// One contender on one picture.
struct Row {
  std::string contender;
  Score score;
  std::vector<double> cpu_seconds;  ///< a round each; none for the floor
};

struct Picture {
  std::string name;
  ImageSize size;
  std::size_t colours = 0;     ///< different ones
  std::size_t lattice = 0;     ///< different ones on the DAC's lattice
  Score floor, floor_as_seen;  ///< on_the_lattice, on_the_lattice_as_seen; the latter if trivial
  std::vector<Row> rows;

  /// No choice is needed: the lattice alone limits. Listed apart, not in the means.
  bool trivial() const { return lattice <= 256; }
  const Row* find(const std::string& contender) const;
};

/// A figure of the summary beside what it must and should come to.
struct Target {
  std::string what;
  double measured = 0;
  std::optional<double> must, aim;  ///< without both it is told only
  bool at_most = true;
  std::string note;  ///< the worst picture's name

  bool met(const std::optional<double>& bound) const {
    return !bound || (at_most ? measured <= *bound : measured >= *bound);
  }
};

using Pictures = std::vector<Picture>;

/// The pictures that are not trivial and have rows of both contenders.
std::vector<const Picture*> contested(const Pictures& pictures, const std::string& a,
                                      const std::string& b);

/// Rows' CPU: of each round, `contender`'s seconds over the reference's, both summed over the
/// pictures; the median of the rounds.
double summed_cpu_ratio(const std::vector<const Picture*>& pictures, const std::string& contender);
double cpu_ratio(const Picture& picture, const std::string& contender);

/// The targets of the methods that were measured, in the order of printing.
std::vector<Target> plain_targets(const Pictures& pictures);
std::vector<Target> dither_targets(const Pictures& pictures);

}  // namespace sir::bench
