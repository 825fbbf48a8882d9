#include "cli/cost/pareto.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace sir::cli {

std::vector<bool> pareto_front(std::span<const Offer> offers) {
  std::vector<std::size_t> order(offers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (offers[a].time != offers[b].time) return offers[a].time < offers[b].time;
    return offers[a].quality > offers[b].quality;
  });
  // From the cheapest on, what is better than all before it, and what equals such a one.
  std::vector<bool> front(offers.size());
  const Offer* best = nullptr;
  for (const std::size_t i : order) {
    const Offer& offer = offers[i];
    const bool equal = best && offer.time == best->time && offer.quality == best->quality;
    if (!best || offer.quality > best->quality) best = &offer;
    else if (!equal) continue;
    front[i] = true;
  }
  return front;
}

}  // namespace sir::cli
