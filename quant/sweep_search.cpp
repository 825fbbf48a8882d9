#include "quant/sweep_search.h"

#include <algorithm>
#include <array>

namespace sir::quant {
namespace {

using Nearest = SweepSearch::Nearest;

constexpr std::size_t kSteps = 1024;

bool before(float difference, std::uint32_t index, const Nearest& other) {
  return difference < other.difference || (difference == other.difference && index < other.index);
}

struct KeepOne {
  Nearest first;
  float worst() const { return first.difference; }
  void offer(float difference, std::uint32_t index) {
    if (before(difference, index, first)) first = {index, difference};
  }
};

struct KeepTwo {
  Nearest first, second;
  float worst() const { return second.difference; }
  void offer(float difference, std::uint32_t index) {
    if (before(difference, index, first)) {
      second = first;
      first = {index, difference};
    } else if (before(difference, index, second)) {
      second = {index, difference};
    }
  }
};

}  // namespace

SweepSearch::SweepSearch(std::span<const glm::vec3> entries) {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  entries_.push_back({{-kFar, 0, 0}, 0});
  for (std::size_t i = 0; i < entries.size(); ++i)
    entries_.push_back({entries[i], static_cast<std::uint32_t>(i)});
  std::stable_sort(entries_.begin() + 1, entries_.end(),
                   [](const Entry& a, const Entry& b) { return a.at.x < b.at.x; });
  entries_.push_back({{kFar, 0, 0}, 0});
  const float low = entries_[1].at.x, high = entries_[entries_.size() - 2].at.x;
  origin_ = low;
  steps_ = high > low ? static_cast<float>(kSteps - 1) / (high - low) : 0;
  start_.resize(kSteps);
  std::size_t entry = 1;
  for (std::size_t step = 0; step < kSteps; ++step) {
    while (entry + 1 < entries_.size() - 1 &&
           (entries_[entry].at.x - origin_) * steps_ < static_cast<float>(step))
      ++entry;
    start_[step] = static_cast<std::uint16_t>(entry);
  }
}

template <typename Keep>
void SweepSearch::sweep(const glm::vec3& at, const Form& form, Keep& keep) const {
  const float step = std::clamp((at.x - origin_) * steps_, 0.0f, static_cast<float>(kSteps - 1));
  const Entry* up = entries_.data() + start_[static_cast<std::size_t>(step)];
  const Entry* down = up - 1;
  // The bound of an end is infinite; a bound that equals the worst may still be a tie.
  const auto bound = [&](const Entry* entry) {
    const float dx = at.x - entry->at.x;
    return form.xx * dx * dx;
  };
  float bound_up = bound(up), bound_down = bound(down);
  const Entry* const last = entries_.data() + entries_.size() - 1;
  const Entry* const first = entries_.data();
  for (;;) {
    const bool upwards = bound_up < bound_down;
    const float least = upwards ? bound_up : bound_down;
    const Entry* const entry = upwards ? up : down;
    if (least > keep.worst() || entry == last || entry == first) return;
    keep.offer(form(at - entry->at), entry->index);
    if (upwards) bound_up = bound(++up);
    else bound_down = bound(--down);
  }
}

SweepSearch::Nearest SweepSearch::nearest(const glm::vec3& at, const Form& form) const {
  KeepOne keep;
  sweep(at, form, keep);
  return keep.first;
}

SweepSearch::Two SweepSearch::nearest_two(const glm::vec3& at, const Form& form) const {
  KeepTwo keep;
  sweep(at, form, keep);
  return {keep.first, keep.second};
}

}  // namespace sir::quant
