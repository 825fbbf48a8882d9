#include "tracer/hierarchy.h"

#include <algorithm>
#include <numeric>

namespace sir {

template <typename T>
Hierarchy<T>::Hierarchy(std::span<const Bounds<T>> boxes) {
  if (boxes.empty()) return;
  order_.resize(boxes.size());
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.reserve(boxes.size());
  nodes_.push_back({{}, 0, static_cast<std::uint32_t>(boxes.size())});
  // Nodes are split in place until their share is small; the list grows behind.
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const std::uint32_t first = nodes_[n].first, size = nodes_[n].size;
    Bounds<T> all, centres;
    for (std::uint32_t i = first; i < first + size; ++i) {
      all.include(boxes[order_[i]]);
      const auto centre = boxes[order_[i]].centre();
      centres.include({centre, centre});
    }
    nodes_[n].bounds = all;
    if (size <= kLeafSize) continue;
    const auto extent = centres.high - centres.low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                     : extent.y >= extent.z                       ? 1
                                                                  : 2;
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + size / 2, begin + size, [&](std::uint32_t a, std::uint32_t b) {
      const T at_a = boxes[a].centre()[axis], at_b = boxes[b].centre()[axis];
      return at_a != at_b ? at_a < at_b : a < b;
    });
    nodes_[n].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[n].size = 0;
    nodes_.push_back({{}, first, size / 2});
    nodes_.push_back({{}, first + size / 2, size - size / 2});
  }
  boxes_.reserve(boxes.size());
  for (const std::uint32_t i : order_) boxes_.push_back(boxes[i]);
}

template class Hierarchy<float>;
template class Hierarchy<double>;
template class Hierarchy<long double>;

}  // namespace sir
