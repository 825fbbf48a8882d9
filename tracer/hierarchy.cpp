#include "tracer/hierarchy.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace sir {
namespace {

constexpr int kBins = 16;
// Nodes deeper than this are halved: what is left is gone after 32 more.
constexpr std::uint8_t kFreeDepth = 36;
// Infinite boxes have places that are no numbers, and empty ones (low > high) may lie anywhere:
// what is beyond the envelope, which goes from -1 to 1, is as far as it is wide.
constexpr float kFar = 2;

// Where boxes are parted needs few digits: what is sorted are floats, in units of the
// whole envelope, from its centre. The envelopes of the nodes are T's again.
using Four [[gnu::vector_size(16)]] = float;  // x, y, z, and a fourth for the hardware's sake

Four lesser(Four a, Four b) { return a < b ? a : b; }
Four greater(Four a, Four b) { return a < b ? b : a; }

struct Extent {
  static constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Four low{kInfinity, kInfinity, kInfinity, kInfinity};
  Four high{-kInfinity, -kInfinity, -kInfinity, -kInfinity};

  void include(const Extent& other) {
    low = lesser(low, other.low);
    high = greater(high, other.high);
  }
  // Half the surface; that of an empty one is 0.
  float surface() const {
    const Four side = greater(high - low, Four{});
    return side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
  }
};

// A box to be sorted into the hierarchy, with its centre beside it.
struct Item {
  Extent box;
  Four centre;
  std::uint32_t index;
};

template <typename T>
std::vector<Item> items_of(std::span<const Bounds<T>> boxes) {
  Bounds<T> all;
  for (const Bounds<T>& box : boxes) all.include(box);
  const auto middle = all.centre();
  // The envelope may be larger than a T can tell.
  const auto half = all.high / T(2) - all.low / T(2);
  const T size = std::max({half.x, half.y, half.z, std::numeric_limits<T>::min()});
  const auto unit = [&](const glm::vec<3, T>& point) {
    const glm::vec3 v((point - middle) / size);
    const auto number = [](float x) { return std::isnan(x) ? 0.0f : std::clamp(x, -kFar, kFar); };
    return Four{number(v.x), number(v.y), number(v.z), 0};
  };
  std::vector<Item> items;
  items.reserve(boxes.size());
  for (const Bounds<T>& box : boxes)
    items.push_back({{unit(box.low), unit(box.high)},
                     unit(box.centre()),
                     static_cast<std::uint32_t>(items.size())});
  return items;
}

class Splitter {
 public:
  explicit Splitter(std::span<Item> items) : items_(items) {
    for (const Item& item : items) {
      low_ = lesser(low_, item.centre);
      high_ = greater(high_, item.centre);
    }
  }

  // Reorders the items; how many go to the first half.
  std::uint32_t split(bool halve) {
    const auto size = static_cast<std::uint32_t>(items_.size());
    if (!halve) {
      const auto [axis, last] = cheapest();
      if (axis >= 0) {
        const auto middle = std::partition(items_.begin(), items_.end(), [&](const Item& item) {
          return bins_of(item)[axis] <= last;
        });
        const auto count = static_cast<std::uint32_t>(middle - items_.begin());
        if (count > 0 && count < size) return count;
      }
    }
    const Four extent = high_ - low_;
    const int axis = extent[0] >= extent[1] && extent[0] >= extent[2] ? 0
                     : extent[1] >= extent[2]                         ? 1
                                                                      : 2;
    std::nth_element(items_.begin(), items_.begin() + size / 2, items_.end(),
                     [&](const Item& a, const Item& b) {
                       const float at_a = a.centre[axis], at_b = b.centre[axis];
                       return at_a != at_b ? at_a < at_b : a.index < b.index;
                     });
    return size / 2;
  }

 private:
  using FourBins [[gnu::vector_size(16)]] = std::int32_t;
  // A place between the bins of an axis: behind bin `last`. No axis: -1.
  struct Place {
    int axis = -1, last = 0;
  };
  struct Bins {
    std::array<Extent, kBins> box;
    std::array<std::uint32_t, kBins> count{};
    std::uint32_t used = 0;  // a bit for each that holds something
  };

  FourBins bins_of(const Item& item) const {
    const auto bins = __builtin_convertvector((item.centre - low_) * scale_, FourBins);
    return bins < kBins - 1 ? bins : FourBins{} + (kBins - 1);
  }

  // The place where the halves' surfaces, weighted by what they hold, are least.
  Place cheapest() {
    const Four extent = high_ - low_;
    for (int axis = 0; axis < 3; ++axis) {
      const float scale = kBins / extent[axis];
      scale_[axis] = std::isfinite(scale) && std::isfinite(extent[axis]) ? scale : 0;
    }
    std::array<Bins, 3> bins;
    for (const Item& item : items_) {
      const FourBins at = bins_of(item);
      for (int axis = 0; axis < 3; ++axis) {
        Bins& along = bins[static_cast<std::size_t>(axis)];
        const auto b = static_cast<std::size_t>(at[axis]);
        along.box[b].include(item.box);
        ++along.count[b];
        along.used |= 1u << b;
      }
    }
    Place best;
    float least = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis)
      try_axis(bins[static_cast<std::size_t>(axis)], axis, least, best);
    return best;
  }

  // Keeps the best of the places of one axis: each behind a bin that holds something.
  static void try_axis(const Bins& bins, int axis, float& least, Place& best) {
    float beyond[kBins];  // what lies behind bin b costs
    Extent rest;
    std::uint32_t resting = 0;
    for (std::uint32_t used = bins.used; used != 0;) {
      const auto b = static_cast<std::size_t>(std::bit_width(used) - 1);
      used ^= 1u << b;
      beyond[b] = rest.surface() * static_cast<float>(resting);
      rest.include(bins.box[b]);
      resting += bins.count[b];
    }
    Extent below;
    std::uint32_t lying = 0;
    for (std::uint32_t used = bins.used; (used & (used - 1)) != 0; used &= used - 1) {
      const auto b = static_cast<std::size_t>(std::countr_zero(used));
      below.include(bins.box[b]);
      lying += bins.count[b];
      const float cost = below.surface() * static_cast<float>(lying) + beyond[b];
      if (!(cost < least)) continue;
      least = cost;
      best = {axis, static_cast<int>(b)};
    }
  }

  std::span<Item> items_;
  Four low_ = Extent().low, high_ = Extent().high;  // of the centres
  Four scale_{};
};

}  // namespace

template <typename T>
Hierarchy<T>::Hierarchy(std::span<const Bounds<T>> boxes) {
  if (boxes.empty()) return;
  std::vector<Item> items = items_of(boxes);
  nodes_.reserve(2 * boxes.size());
  nodes_.push_back({{}, 0, static_cast<std::uint32_t>(boxes.size())});
  std::vector<std::uint8_t> depth{0};
  depth.reserve(2 * boxes.size());
  // Nodes are split in place until their share is small; the list grows behind.
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const std::uint32_t first = nodes_[n].first, size = nodes_[n].size;
    if (size <= kLeafSize) continue;
    Splitter splitter({items.data() + first, size});
    const std::uint32_t half = splitter.split(depth[n] >= kFreeDepth);
    nodes_[n].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[n].size = 0;
    nodes_.push_back({{}, first, half});
    nodes_.push_back({{}, first + half, size - half});
    depth.insert(depth.end(), 2, static_cast<std::uint8_t>(depth[n] + 1));
  }
  order_.reserve(boxes.size());
  boxes_.reserve(boxes.size());
  for (const Item& item : items) {
    order_.push_back(item.index);
    boxes_.push_back(boxes[item.index]);
  }
  // Children stand behind their parents.
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    Node& node = nodes_[n];
    for (std::uint32_t i = 0; i < node.size; ++i) node.bounds.include(boxes_[node.first + i]);
    if (node.size > 0) continue;
    for (std::uint32_t child : {0u, 1u}) node.bounds.include(nodes_[node.first + child].bounds);
  }
}

template class Hierarchy<float>;
template class Hierarchy<double>;
template class Hierarchy<long double>;

}  // namespace sir
