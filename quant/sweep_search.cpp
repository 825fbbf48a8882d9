#include "quant/sweep_search.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <stdexcept>

#include "quant/clones.h"

namespace sir::quant {

SweepSearch::SweepSearch(std::span<const glm::vec3> entries) {
  if (entries.empty()) throw std::invalid_argument("a search among no entries");
  std::vector<std::uint32_t> order(entries.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return entries[a].x < entries[b].x; });
  for (std::size_t first = 0; first < order.size(); first += kLanes) {
    Row& row = rows_.emplace_back();
    for (std::size_t k = 0; k < kLanes; ++k) {
      row.index[k] = order[std::min(first + k, order.size() - 1)];
      const glm::vec3& entry = entries[row.index[k]];
      row.x[k] = entry.x;
      row.y[k] = entry.y;
      row.z[k] = entry.z;
    }
  }
  constexpr float kFar = std::numeric_limits<float>::infinity();
  high_.push_back(-kFar);
  for (const Row& row : rows_) {
    low_.push_back(row.x.front());
    high_.push_back(row.x.back());
  }
  low_.push_back(kFar);

  origin_ = rows_.front().x.front();
  const float width = rows_.back().x.back() - origin_;
  if (width > 0) steps_ = static_cast<float>(kSteps - 1) / width;
  std::size_t row = 0;
  for (std::size_t step = 0; step < kSteps; ++step) {
    while (row + 1 < rows_.size() &&
           (rows_[row].x.back() - origin_) * steps_ < static_cast<float>(step))
      ++row;
    start_[step] = static_cast<std::uint16_t>(row);
  }
}

void SweepSearch::look(const Row& row, const glm::vec3& at, const Form& form,
                       Nearest& nearest) const {
  std::array<std::int32_t, kLanes> difference;  // positive floats order as their bits do
  for (std::size_t k = 0; k < kLanes; ++k) {
    const float x = at.x - row.x[k], y = at.y - row.y[k], z = at.z - row.z[k];
    difference[k] = std::bit_cast<std::int32_t>(
        form.xx * x * x + (form.yy * y * y + form.zz * z * z + form.yz * y * z));
  }
  std::int32_t least = difference[0];
  for (std::size_t k = 1; k < kLanes; ++k) least = std::min(least, difference[k]);
  if (least > std::bit_cast<std::int32_t>(nearest.difference)) return;
  for (std::size_t k = 0; k < kLanes; ++k) {
    const float one = std::bit_cast<float>(difference[k]);
    if (one < nearest.difference || (one == nearest.difference && row.index[k] < nearest.index))
      nearest = {row.index[k], one};
  }
}

SIR_CLONES SweepSearch::Nearest SweepSearch::nearest(const glm::vec3& at, const Form& form) const {
  const float step = std::clamp((at.x - origin_) * steps_, 0.0f, static_cast<float>(kSteps - 1));
  std::size_t up = start_[static_cast<std::size_t>(step)];
  std::size_t down = up;  // rows from down to up - 1 have been looked at
  Nearest nearest;
  look(rows_[up++], at, form, nearest);
  // A bound that equals the least may still be that of a tie. Any row may be the first: a bound
  // holds for all rows beyond only where the row lies on its side of the colour.
  for (;;) {
    const float above = std::max(low_[up] - at.x, 0.0f), below = std::max(at.x - high_[down], 0.0f);
    const bool upwards = above < below;
    const float bound = upwards ? form.xx * above * above : form.xx * below * below;
    if (bound > nearest.difference || (up == rows_.size() && down == 0)) return nearest;
    if (upwards) look(rows_[up++], at, form, nearest);
    else look(rows_[--down], at, form, nearest);
  }
}

}  // namespace sir::quant
