// Which settings are worth their time.
#pragma once

#include <span>
#include <vector>

namespace sir::cli {

struct Offer {
  double time = 0;     ///< any unit
  double quality = 0;  ///< more is better; may be infinite
};

/// For each offer whether it is on the Pareto front: no other one is at least
/// as good in both and better in one. Equal offers stand or fall together.
std::vector<bool> pareto_front(std::span<const Offer> offers);

}  // namespace sir::cli
