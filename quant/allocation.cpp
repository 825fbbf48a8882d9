#include "quant/allocation.h"

#include <algorithm>
#include <numeric>

namespace sir::quant {

std::vector<std::size_t> allocate(std::size_t entries, std::span<const PlaneClaim> planes) {
  std::size_t all = 0;
  for (const PlaneClaim& plane : planes) all += plane.cells;
  std::vector<std::size_t> shares;
  if (all <= entries) {
    for (const PlaneClaim& plane : planes) shares.push_back(plane.cells);
    return shares;
  }
  std::size_t left = entries;
  for (const PlaneClaim& plane : planes) {
    shares.push_back(entries * plane.cells / all);
    left -= shares.back();
  }
  std::vector<std::size_t> order(planes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto remainder = [&](std::size_t plane) { return entries * planes[plane].cells % all; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (remainder(a) != remainder(b)) return remainder(a) > remainder(b);
    return planes[a].pixels > planes[b].pixels;
  });
  // The remainders add up to left * all and each is below all, so more than
  // `left` planes have one (or none is left): an exact share stays exact.
  for (std::size_t i = 0; i < left; ++i) ++shares[order[i]];
  return shares;
}

}  // namespace sir::quant
