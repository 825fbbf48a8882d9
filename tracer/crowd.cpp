#include "tracer/crowd.h"

#include <algorithm>
#include <vector>

namespace sir {

template <typename T>
std::uint32_t crowd_of(const Hierarchy<T>& hierarchy, T gap) {
  constexpr std::uint32_t kMost = 64;
  std::vector<std::uint32_t> having(kMost + 1);  // boxes with so many near them, or more
  std::uint32_t crowd = 0, above = 0;            // of the boxes so far; with more near them
  // Neighbours in the hierarchy's order have about the same boxes near them: these are
  // looked for once for a group, and counted only where they may make a larger crowd.
  constexpr std::size_t kGroup = 4, kGathered = 8 * kMost;
  const auto boxes = hierarchy.boxes();
  const T reach = 2 * gap;
  std::vector<Bounds<T>> gathered;
  for (std::size_t first = 0; first < boxes.size(); first += kGroup) {
    const auto group = boxes.subspan(first, std::min(kGroup, boxes.size() - first));
    Bounds<T> all;
    for (const Bounds<T>& box : group) all.include(box);
    gathered.clear();
    hierarchy.for_each_box_near(all, reach, [&](std::size_t place) {
      gathered.push_back(boxes[place]);
      return gathered.size() > kGathered;
    });
    if (gathered.size() <= std::min(crowd, kMost - 1)) continue;
    for (const Bounds<T>& box : group) {
      std::uint32_t count = 0;
      if (gathered.size() > kGathered) {
        hierarchy.for_each_near(box, reach, [&](std::uint32_t) { return ++count == kMost; });
      } else {
        for (const Bounds<T>& other : gathered) count += other.near(box, reach);
      }
      count = std::min(count, kMost);
      ++having[count];
      if (count <= crowd) continue;
      ++above;
      while (above > crowd && crowd < kMost) above -= having[++crowd];
    }
  }
  return crowd == kMost ? having[kMost] : std::max(crowd, 1u);
}

template std::uint32_t crowd_of(const Hierarchy<float>&, float);
template std::uint32_t crowd_of(const Hierarchy<double>&, double);
template std::uint32_t crowd_of(const Hierarchy<long double>&, long double);

}  // namespace sir
