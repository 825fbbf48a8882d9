#include "tracer/envelope_tree.h"

namespace sir {
namespace {

template <typename T>
Bounds<T> combined(Operation operation, const Bounds<T>& left, const Bounds<T>& right) {
  Bounds<T> box = left;
  if (operation == Operation::union_of) box.include(right);
  if (operation == Operation::intersection) {
    box.low = glm::max(left.low, right.low);
    box.high = glm::min(left.high, right.high);
  }
  return box;
}

}  // namespace

template <typename T>
EnvelopeTree<T>::EnvelopeTree(const Solid<T>& solid) {
  boxes_.reserve(solid.polish.size());
  sizes_.reserve(solid.polish.size());
  for (const PolishStep& step : solid.polish) {
    if (step.is_leaf) {
      const Leaf<T>& leaf = solid.leaves[step.leaf];
      boxes_.push_back(bounds_of(leaf.kind, leaf.placement));
      sizes_.push_back(1);
      continue;
    }
    const std::size_t right = boxes_.size() - 1, left = right - sizes_[right];
    sizes_.push_back(sizes_[left] + sizes_[right] + 1);
    boxes_.push_back(combined(step.operation, boxes_[left], boxes_[right]));
  }
}

template <typename T>
void EnvelopeTree<T>::visit(const BoxProbe<T>& probe, T farthest, std::vector<Visit>& visits,
                            CostCounts& costs) const {
  visits.clear();
  std::uint64_t entered = 0;
  // Read backwards, a node stands before what is below it.
  for (auto step = static_cast<std::uint32_t>(boxes_.size()); step-- > 0;) {
    const Bounds<T>& box = boxes_[step];
    // Solids that do not meet have an empty box in common.
    const bool empty = box.low.x > box.high.x || box.low.y > box.high.y || box.low.z > box.high.z;
    const bool met = !empty && probe.meets(box, farthest);
    visits.push_back({step, met});
    entered += met;
    if (!met) step -= sizes_[step] - 1;
  }
  costs.envelopes += visits.size();
  costs.calls += entered;
  std::reverse(visits.begin(), visits.end());
}

template class EnvelopeTree<float>;
template class EnvelopeTree<double>;
template class EnvelopeTree<long double>;

}  // namespace sir
