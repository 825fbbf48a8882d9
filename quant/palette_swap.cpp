#include <algorithm>
#include <numeric>
#include <utility>

#include "quant/lattice_place.h"
#include "quant/palette.h"

namespace sir::quant {
namespace {

// The numbers 0 to count - 1 by a key, the lower number first where keys are equal.
template <typename Key>
std::vector<std::uint32_t> sorted_by(std::size_t count, Key key) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  std::stable_sort(numbers.begin(), numbers.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  return numbers;
}

}  // namespace

std::size_t Palette::swap(std::size_t most, double worth) {
  constexpr int kSteps = 2;
  Order groups = order();
  std::vector<PrincipalSplit> splits;
  for (std::size_t i = 0; i < size(); ++i)
    splits.push_back(principal_split(points_, groups.of(i), sums_[i]));
  const auto misses = missed();
  const auto by_gain = sorted_by(size(), [&](std::uint32_t i) { return -splits[i].gain; });
  const auto by_loss = sorted_by(size(), [&](std::uint32_t i) { return misses[i]; });

  const Palette before = *this;
  std::vector<std::uint8_t> used(size());
  for (std::size_t i = 0; i < size(); ++i) used[i] = !rules_[i].free();
  std::size_t moved = 0;
  auto losing = by_loss.begin();
  for (const std::uint32_t gaining : by_gain) {
    if (moved == most) break;
    if (used[gaining]) continue;
    while (losing != by_loss.end() && (used[*losing] || *losing == gaining)) ++losing;
    if (losing == by_loss.end() || !(splits[gaining].gain > worth * misses[*losing])) break;
    const Group all = groups.of(gaining);
    const std::size_t below = divide(points_, all, splits[gaining]);
    if (below == 0 || below == all.size()) continue;  // the threshold's rounding
    const FormSum lower = sum_of(points_, all.first(below)),
                  upper = sum_of(points_, all.subspan(below));
    for (const auto& [entry, sum] : {std::pair(gaining, &lower), std::pair(*losing, &upper)}) {
      if (held_) move(entry, best_code(*sum, dac_, *measure_));
      else move(entry, glm::vec3(sum->best()));
      used[entry] = 1;
    }
    ++moved;
  }
  if (moved == 0) return 0;
  assign();
  for (int i = 0; i < kSteps; ++i) step();
  if (cost() < before.cost()) return moved;
  *this = before;
  return 0;
}

}  // namespace sir::quant
