#include "tests/property_membership.h"

#include <algorithm>
#include <cmath>

namespace sir::test {
namespace {

template <typename W>
W least(W a, W b) {
  return b < a ? b : a;
}

// Positive inside, negative outside; near the surface at least as small as the
// distance from it, but for a factor of 2.
template <typename W>
W depth(PrimitiveKind kind, W x, W y, W z) {
  const W one = 1;
  switch (kind) {
    case PrimitiveKind::cube:
      return least(least(least(x, one - x), least(y, one - y)), least(z, one - z));
    case PrimitiveKind::sphere: return one - (x * x + y * y + z * z);
    case PrimitiveKind::cone:
      return least(least(y, one - y), (one - y) * (one - y) - (x * x + z * z));
    case PrimitiveKind::cylinder: return least(least(y, one - y), one - (x * x + z * z));
  }
  return -one;
}

Side combine(Operation operation, Side a, Side b) {
  if (operation == Operation::difference && b != Side::undecided)
    b = b == Side::inside ? Side::outside : Side::inside;
  // What settles the matter on its own.
  const Side settling = operation == Operation::union_of ? Side::inside : Side::outside;
  if (a == settling || b == settling) return settling;
  if (a == Side::undecided || b == Side::undecided) return Side::undecided;
  return settling == Side::inside ? Side::outside : Side::inside;
}

}  // namespace

Membership::Membership(const Scene& scene) {
  std::vector<std::size_t> open{scene.tree.root};
  while (!open.empty()) {  // node, right, left: reverse Polish backwards
    const CsgNode& node = scene.tree.nodes[open.back()];
    open.pop_back();
    steps_.push_back({!node.composite, node.operation, leaves_.size()});
    if (node.composite) {
      open.push_back(node.left);
      open.push_back(node.right);
      continue;
    }
    const glm::dmat3& m = node.placement.linear;
    Leaf leaf{};
    leaf.kind = node.kind;
    leaf.translation = node.placement.translation;
    const auto entry = [&](int row, int column) { return Quad(m[column % 3][row % 3]); };
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        leaf.adjugate[static_cast<std::size_t>(3 * row + column)] =
            entry(column + 1, row + 1) * entry(column + 2, row + 2) -
            entry(column + 1, row + 2) * entry(column + 2, row + 1);
    for (std::size_t i = 0; i < 3; ++i)
      leaf.determinant += leaf.adjugate[i] * entry(static_cast<int>(i), 0);
    for (std::size_t row = 0; row < 3; ++row) {
      double sum = 0;
      for (std::size_t column = 0; column < 3; ++column) {
        const std::size_t at = 3 * row + column;
        leaf.inverse[at] = static_cast<double>(leaf.adjugate[at] / leaf.determinant);
        sum += std::abs(leaf.inverse[at]);
      }
      leaf.stretch = std::max(leaf.stretch, sum);
    }
    leaves_.push_back(leaf);
  }
  std::reverse(steps_.begin(), steps_.end());
}

Side Membership::side_of(const Leaf& leaf, const glm::dvec3& point, double extent, double epsilon) {
  const double margin = 4096 * epsilon * (1 + leaf.stretch * extent);
  const glm::dvec3 from = point - leaf.translation;
  const auto& a = leaf.inverse;
  const double rough = depth<double>(leaf.kind, a[0] * from.x + a[1] * from.y + a[2] * from.z,
                                     a[3] * from.x + a[4] * from.y + a[5] * from.z,
                                     a[6] * from.x + a[7] * from.y + a[8] * from.z);
  // The double's own error is some 10 of its roundings, against 4096.
  if (std::abs(rough) > 2 * margin) return rough > 0 ? Side::inside : Side::outside;
  std::array<Quad, 3> local;
  for (std::size_t row = 0; row < 3; ++row) {
    Quad sum = 0;
    for (std::size_t column = 0; column < 3; ++column) {
      const int axis = static_cast<int>(column);
      sum += leaf.adjugate[3 * row + column] * (Quad(point[axis]) - Quad(leaf.translation[axis]));
    }
    local[row] = sum / leaf.determinant;
  }
  const auto exact = static_cast<double>(depth<Quad>(leaf.kind, local[0], local[1], local[2]));
  if (std::abs(exact) <= margin) return Side::undecided;
  return exact > 0 ? Side::inside : Side::outside;
}

Side Membership::of(const glm::dvec3& point, double extent, double epsilon) const {
  std::array<Side, 64> stack{};
  std::vector<Side> large;  // for trees deeper than any of the tests'
  Side* top = stack.data();
  if (steps_.size() > stack.size()) {
    large.resize(steps_.size());
    top = large.data();
  }
  for (const Step& step : steps_) {
    if (step.leaf) {
      *top++ = side_of(leaves_[step.index], point, extent, epsilon);
    } else {
      --top;
      top[-1] = combine(step.operation, top[-1], top[0]);
    }
  }
  return top[-1];
}

}  // namespace sir::test
