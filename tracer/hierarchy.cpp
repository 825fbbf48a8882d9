#include "tracer/hierarchy.h"

#include <algorithm>
#include <numeric>

namespace sir {
namespace {

constexpr std::size_t kBins = 16;
// Nodes deeper than this are halved: what is left is gone after 32 more.
constexpr std::uint8_t kFreeDepth = 36;

// Half a box's surface; that of an empty one is 0.
template <typename T>
T surface(const Bounds<T>& box) {
  const auto side = glm::max(box.high - box.low, glm::vec<3, T>(0));
  return side.x * side.y + side.y * side.z + side.z * side.x;
}

template <typename T>
class Splitter {
 public:
  Splitter(std::span<const Bounds<T>> boxes, std::vector<std::uint32_t>& order)
      : boxes_(boxes), order_(order) {
    centres_.reserve(boxes.size());
    for (const Bounds<T>& box : boxes) centres_.push_back(box.centre());
  }

  // The envelopes of order[first .. first + size), and of their centres.
  void measure(std::uint32_t first, std::uint32_t size) {
    all_ = spread_ = {};
    for (std::uint32_t i = first; i < first + size; ++i) {
      all_.include(boxes_[order_[i]]);
      const auto& centre = centres_[order_[i]];
      spread_.include({centre, centre});
    }
  }
  const Bounds<T>& bounds() const { return all_; }

  // Reorders what was measured; how many go to the first half.
  std::uint32_t split(std::uint32_t first, std::uint32_t size, bool halve) {
    const auto extent = spread_.high - spread_.low;
    if (!halve) {
      T least = std::numeric_limits<T>::infinity();
      int axis = -1;
      std::size_t last = 0;
      for (int candidate = 0; candidate < 3; ++candidate)
        if (extent[candidate] > 0 && std::isfinite(extent[candidate]))
          try_axis(first, size, candidate, least, axis, last);
      if (axis >= 0) {
        const auto begin = order_.begin() + first;
        const auto middle = std::partition(
            begin, begin + size, [&](std::uint32_t i) { return bin_of(i, axis) <= last; });
        const auto count = static_cast<std::uint32_t>(middle - begin);
        if (count > 0 && count < size) return count;
      }
    }
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                     : extent.y >= extent.z                       ? 1
                                                                  : 2;
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + size / 2, begin + size, [&](std::uint32_t a, std::uint32_t b) {
      const T at_a = centres_[a][axis], at_b = centres_[b][axis];
      return at_a != at_b ? at_a < at_b : a < b;
    });
    return size / 2;
  }

 private:
  struct Bin {
    Bounds<T> bounds;
    std::uint32_t count = 0;
  };

  std::size_t bin_of(std::uint32_t i, int axis) const {
    const T part = (centres_[i][axis] - spread_.low[axis]) * scale_[axis];
    return std::min(static_cast<std::size_t>(part), kBins - 1);
  }

  // Keeps the best of the places between the bins of one axis.
  void try_axis(std::uint32_t first, std::uint32_t size, int candidate, T& least, int& axis,
                std::size_t& last) {
    scale_[candidate] = static_cast<T>(kBins) / (spread_.high[candidate] - spread_.low[candidate]);
    if (!std::isfinite(scale_[candidate])) return;
    std::array<Bin, kBins> bins;
    for (std::uint32_t i = first; i < first + size; ++i) {
      Bin& bin = bins[bin_of(order_[i], candidate)];
      bin.bounds.include(boxes_[order_[i]]);
      ++bin.count;
    }
    std::array<T, kBins> beyond{};  // what lies behind bin b costs
    Bin rest;
    for (std::size_t b = kBins - 1; b > 0; --b) {
      rest.bounds.include(bins[b].bounds);
      rest.count += bins[b].count;
      beyond[b - 1] = surface(rest.bounds) * static_cast<T>(rest.count);
    }
    Bin below;
    for (std::size_t b = 0; b + 1 < kBins; ++b) {
      below.bounds.include(bins[b].bounds);
      below.count += bins[b].count;
      if (below.count == 0 || below.count == size) continue;
      const T cost = surface(below.bounds) * static_cast<T>(below.count) + beyond[b];
      if (!(cost < least)) continue;
      least = cost;
      axis = candidate;
      last = b;
    }
  }

  std::span<const Bounds<T>> boxes_;
  std::vector<std::uint32_t>& order_;
  std::vector<glm::vec<3, T>> centres_;
  Bounds<T> all_, spread_;
  glm::vec<3, T> scale_{0};
};

}  // namespace

template <typename T>
Hierarchy<T>::Hierarchy(std::span<const Bounds<T>> boxes) {
  if (boxes.empty()) return;
  order_.resize(boxes.size());
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.reserve(boxes.size());
  nodes_.push_back({{}, 0, static_cast<std::uint32_t>(boxes.size())});
  std::vector<std::uint8_t> depth{0};
  depth.reserve(boxes.size());
  Splitter<T> splitter(boxes, order_);
  // Nodes are split in place until their share is small; the list grows behind.
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const std::uint32_t first = nodes_[n].first, size = nodes_[n].size;
    splitter.measure(first, size);
    nodes_[n].bounds = splitter.bounds();
    if (size <= kLeafSize) continue;
    const std::uint32_t half = splitter.split(first, size, depth[n] >= kFreeDepth);
    nodes_[n].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[n].size = 0;
    nodes_.push_back({{}, first, half});
    nodes_.push_back({{}, first + half, size - half});
    depth.insert(depth.end(), 2, static_cast<std::uint8_t>(depth[n] + 1));
  }
  boxes_.reserve(boxes.size());
  for (const std::uint32_t i : order_) boxes_.push_back(boxes[i]);
}

template class Hierarchy<float>;
template class Hierarchy<double>;
template class Hierarchy<long double>;

}  // namespace sir
