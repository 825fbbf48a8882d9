#include "tracer/solid.h"

#include <algorithm>
#include <bit>
#include <unordered_map>

#include "tracer/memory_hints.h"

namespace sir {
namespace {

// What rounding to T takes from a number, in units of roundoff. Kept apart: GCC
// 12 takes two of these side by side for a vector and then drops the rounding.
template <typename T>
[[gnu::noinline]] T lost_in_rounding(double exact) {
  const T rounded = static_cast<T>(exact);
  return static_cast<T>(std::abs(exact - double(rounded)) / double(Numeric<T>::kEpsilon / 2));
}

template <typename T>
bool is_power_of_two(T size) {
  int unused = 0;
  return std::frexp(size, &unused) == T(0.5);
}

// Counts the roundings between a ray's coordinates and those in SC_LOCAL.
template <typename T>
void weigh_roundings(const InverseIn<AtLeastDouble<T>>& inverse, Leaf<T>& leaf) {
  constexpr T kRoundoff = Numeric<T>::kEpsilon / 2;
  for (int row = 0; row < 3; ++row) {
    const T divisor = leaf.placement.divisors[row];
    const bool exact_divisor =
        inverse.exact[row] && AtLeastDouble<T>(divisor) == inverse.divisors[row];
    bool exact = inverse.exact[row], trivial = true;
    int terms = 0;
    for (int column = 0; column < 3; ++column) {
      const T entry = leaf.placement.numerators[column][row];
      exact = exact && AtLeastDouble<T>(entry) == inverse.numerators[column][row];
      if (entry == 0) continue;
      ++terms;
      trivial = trivial && is_power_of_two(std::abs(entry));
    }
    // The entries themselves, the products, their sum.
    int roundings = (exact ? 0 : 1) + (trivial ? 0 : 1) + terms - 1;
    if (leaf.unit > 0) {
      if (!exact_divisor) leaf.unit_error = kRoundoff * leaf.unit;
    } else {
      roundings += (exact_divisor ? 0 : 1) + (divisor == 1 ? 0 : 1);
    }
    const T scale = kRoundoff / (leaf.unit > 0 ? T(1) : divisor);
    leaf.direction_weight[row] = T(roundings) * scale * T(1.01);
    leaf.origin_weight[row] = T(roundings + 1) * scale * T(1.01);  // and p - translation
  }
}

// The pace, and whether the inverse's entries are far enough above underflow.
template <typename T>
void set_pace(const InverseIn<AtLeastDouble<T>>& inverse, Leaf<T>& leaf) {
  using Wider = AtLeastDouble<T>;
  Wider largest = 0, least = std::numeric_limits<Wider>::infinity();
  bool kept = true;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) {
      const Wider entry = std::abs(inverse.numerators[column][row]);
      const T rounded = std::abs(leaf.placement.numerators[column][row]);
      if (entry == 0) continue;
      kept = kept && std::isnormal(rounded);
      largest = std::max(largest, entry);
      least = std::min(least, entry);
    }
  leaf.tame = kept && least > Wider(Numeric<T>::kWellAboveUnderflow) * largest;
  if (leaf.tame) leaf.pace = std::ldexp(T(1), -std::ilogb(largest));
  leaf.tame = leaf.tame && std::isnormal(leaf.pace);
}

// Sets what the node itself says of its leaf.
template <typename T>
void set_leaf(const CsgNode& node,
              const std::unordered_map<std::int64_t, std::uint32_t>& surface_index, Leaf<T>& leaf) {
  InverseIn<AtLeastDouble<T>> inverse;
  invert(node.placement.linear, inverse);  // the reader has refused singular ones
  leaf.placement.linear = glm::mat<3, 3, T>(node.placement.linear);
  leaf.placement.numerators = glm::mat<3, 3, T>(inverse.numerators);
  leaf.placement.divisors = glm::vec<3, T>(inverse.divisors);
  if (inverse.divisors.x == inverse.divisors.y && inverse.divisors.x == inverse.divisors.z)
    leaf.unit = leaf.placement.divisors.x;
  weigh_roundings(inverse, leaf);
  leaf.placement.translation = glm::vec<3, T>(node.placement.translation);
  for (int axis = 0; axis < 3; ++axis)
    leaf.translation_slack[axis] = lost_in_rounding<T>(node.placement.translation[axis]);
  leaf.stretch = 0;
  for (int row = 0; row < 3; ++row) {
    AtLeastDouble<T> sum = 0;
    for (int column = 0; column < 3; ++column) sum += std::abs(inverse.entry(row, column));
    leaf.stretch = std::max(leaf.stretch, static_cast<T>(sum));
  }
  for (std::size_t face = 0; face < static_cast<std::size_t>(face_count(node.kind)); ++face)
    leaf.surfaces[face] = face > 0 && node.surfaces[face] == node.surfaces[0]
                              ? leaf.surfaces[0]
                              : surface_index.at(node.surfaces[face]);
  set_pace(inverse, leaf);
  leaf.node = node.number;
  leaf.kind = node.kind;
}

// Gives primitives of one kind and place the same number, in the order of their first.
class Shapes {
 public:
  explicit Shapes(const std::vector<CsgNode>& nodes)
      : number_of_(nodes.size(), Hash{nodes}, Equal{nodes}) {}

  std::uint32_t number_of(std::size_t node) {
    return number_of_.emplace(node, static_cast<std::uint32_t>(number_of_.size())).first->second;
  }

 private:
  static std::array<double, 12> numbers(const Placement& place) {
    const auto& [m, t] = place;
    return {m[0].x, m[0].y, m[0].z, m[1].x, m[1].y, m[1].z, m[2].x, m[2].y, m[2].z, t.x, t.y, t.z};
  }
  struct Hash {
    const std::vector<CsgNode>& nodes;
    std::size_t operator()(std::size_t node) const {
      auto hash = static_cast<std::uint64_t>(nodes[node].kind);
      for (const double number : numbers(nodes[node].placement)) {
        hash ^= std::bit_cast<std::uint64_t>(number + 0.0);  // -0 is 0
        hash = std::rotl(hash * 0x9E3779B97F4A7C15u, 29);
      }
      return hash;
    }
  };
  struct Equal {
    const std::vector<CsgNode>& nodes;
    bool operator()(std::size_t a, std::size_t b) const {
      return nodes[a].kind == nodes[b].kind &&
             numbers(nodes[a].placement) == numbers(nodes[b].placement);
    }
  };

  std::unordered_map<std::size_t, std::uint32_t, Hash, Equal> number_of_;
};

// See Solid::spread.
template <typename T>
T spread_of(const Leaf<T>& leaf) {
  T widest = 0;
  for (int row = 0; row < 3; ++row) {
    T sum = 0;
    for (int column = 0; column < 3; ++column) sum += std::abs(leaf.placement.linear[column][row]);
    widest = std::max(widest, sum);
  }
  return 4 * leaf.stretch * widest;
}

enum class GateKind : std::uint8_t { any, all };

// What a composite becomes, and whether its children are complemented.
struct Rewritten {
  GateKind kind;
  bool left_complemented, right_complemented;
};

Rewritten rewrite(Operation operation, bool complemented) {
  switch (operation) {
    case Operation::union_of:
      return {complemented ? GateKind::all : GateKind::any, complemented, complemented};
    case Operation::intersection:
      return {complemented ? GateKind::any : GateKind::all, complemented, complemented};
    case Operation::difference:
      return {complemented ? GateKind::any : GateKind::all, complemented, !complemented};
  }
  return {GateKind::any, false, false};
}

}  // namespace

template <typename T>
Solid<T> build_solid(const Scene& scene, Formulas formulas) {
  std::unordered_map<std::int64_t, std::uint32_t> surface_index;
  for (const Surface& surface : scene.surfaces)
    surface_index.emplace(surface.number, static_cast<std::uint32_t>(surface_index.size()));

  const auto primitives =
      static_cast<std::size_t>(std::count_if(scene.tree.nodes.begin(), scene.tree.nodes.end(),
                                             [](const CsgNode& node) { return !node.composite; }));
  Solid<T> solid;
  reserve_all(solid.leaves, primitives);
  constexpr bool kHoldsDouble = std::numeric_limits<T>::digits >= 53;
  if (!kHoldsDouble) reserve_all(solid.placements, primitives);
  solid.polish.reserve(scene.tree.nodes.size());
  Shapes shapes(scene.tree.nodes);
  std::vector<GateKind> kind_of;
  std::vector<std::int32_t> inputs;
  struct Open {
    std::size_t node;
    std::int32_t gate;
    bool complemented;
  };
  std::vector<Open> open{{scene.tree.root, -1, false}};
  while (!open.empty()) {
    const Open item = open.back();
    open.pop_back();
    const CsgNode& node = scene.tree.nodes[item.node];
    // Node, right, left is reverse Polish order read backwards.
    solid.polish.push_back(
        {!node.composite, node.operation, static_cast<std::uint32_t>(solid.leaves.size())});
    if (!node.composite) {
      Leaf<T>& leaf = solid.leaves.emplace_back();
      set_leaf(node, surface_index, leaf);
      leaf.shape = shapes.number_of(item.node);
      leaf.gate = item.gate;
      leaf.complemented = item.complemented;
      if (item.gate >= 0) {
        const auto gate = static_cast<std::size_t>(item.gate);
        ++inputs[gate];
        if (item.complemented) ++solid.gates[gate].at_rest;
      }
      if (!kHoldsDouble) solid.placements.push_back(node.placement);
      continue;
    }
    const Rewritten made = rewrite(node.operation, item.complemented);
    std::int32_t gate = item.gate;
    // Like joins like: chains of one operation collapse into one gate.
    if (gate < 0 || kind_of[static_cast<std::size_t>(gate)] != made.kind) {
      if (gate >= 0) ++inputs[static_cast<std::size_t>(gate)];
      solid.gates.push_back({gate, 0, 0});
      kind_of.push_back(made.kind);
      inputs.push_back(0);
      gate = static_cast<std::int32_t>(solid.gates.size()) - 1;
    }
    open.push_back({node.left, gate, made.left_complemented});
    open.push_back({node.right, gate, made.right_complemented});
  }
  std::reverse(solid.polish.begin(), solid.polish.end());

  // Children stand after their parents, so one backward pass settles the rest.
  for (std::size_t g = solid.gates.size(); g-- > 0;) {
    Gate& gate = solid.gates[g];
    gate.needed = kind_of[g] == GateKind::any ? 1 : inputs[g];
    if (gate.at_rest >= gate.needed && gate.parent >= 0)
      ++solid.gates[static_cast<std::size_t>(gate.parent)].at_rest;
  }

  for (const Leaf<T>& leaf : solid.leaves) solid.spread = std::max(solid.spread, spread_of(leaf));
  std::vector<Bounds<T>> boxes;
  boxes.reserve(solid.leaves.size());
  for (const Leaf<T>& leaf : solid.leaves) boxes.push_back(bounds_of(leaf.kind, leaf.placement));
  solid.hierarchy = Hierarchy<T>(boxes);
  if (formulas == Formulas::textbook) {
    for (std::size_t leaf = 0; leaf < solid.leaves.size(); ++leaf)
      solid.textbook.emplace_back(solid.leaves[leaf].kind, solid.placement(leaf));
  } else {
    solid.products = build_products<T>(solid, boxes);
  }
  return solid;
}

template <typename T>
T clearance(const Solid<T>& solid, PointCena<T> point) {
  T least = std::numeric_limits<T>::infinity();
  for (const Leaf<T>& leaf : solid.leaves) {
    if (leaf.complemented) continue;
    const Bounds<T> box = bounds_of(leaf.kind, leaf.placement);
    T most = 0;
    for (int axis = 0; axis < 3; ++axis)
      most = std::max({most, box.low[axis] - point.v[axis], point.v[axis] - box.high[axis]});
    least = std::min(least, most);
  }
  return std::isfinite(least) ? least : T(0);
}

template float clearance(const Solid<float>&, PointCena<float>);
template double clearance(const Solid<double>&, PointCena<double>);
template long double clearance(const Solid<long double>&, PointCena<long double>);
template Solid<float> build_solid(const Scene&, Formulas);
template Solid<double> build_solid(const Scene&, Formulas);
template Solid<long double> build_solid(const Scene&, Formulas);

}  // namespace sir
