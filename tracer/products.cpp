#include "tracer/products.h"

#include <algorithm>

#include "tracer/crowd.h"
#include "tracer/solid.h"

namespace sir {
namespace {

constexpr std::int32_t kEnd = -1;

// A leaf or a gate of the composition as a set. With the complements down at the
// leaves each is either within its box, or everything outside of its box is in it.
template <typename T>
struct Node {
  Bounds<T> box;
  bool bounded = false;
};

template <typename T>
Bounds<T> common(const Bounds<T>& a, const Bounds<T>& b) {
  return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

template <typename T>
Bounds<T> everything() {
  constexpr T kInfinity = std::numeric_limits<T>::infinity();
  return {glm::vec<3, T>(-kInfinity), glm::vec<3, T>(kInfinity)};
}

// Goes through the ways to make every gate of `any` true by one of its inputs, the
// ways that cannot lead to a point left out. What it walks is a conjunction: some
// literals, and nodes still to be looked at. Nodes that are within a box come first,
// so that little is left when it comes to what is cut away.
template <typename T>
class Distributor {
 public:
  Distributor(const Solid<T>& solid, std::span<const Bounds<T>> boxes, Products<T>& products)
      : solid_(solid),
        leaves_(static_cast<std::uint32_t>(solid.leaves.size())),
        nodes_(solid.leaves.size() + solid.gates.size()),
        fans_(solid.gates.size()),
        products_(products),
        steps_left_(64 * solid.leaves.size() + (1u << 17)) {
    link(boxes);
    measure(boxes);
    gather_cutters();
  }

  // False where there are too many.
  bool run() {
    const std::size_t most_parts = kMostParts * leaves_ + 4096;
    const std::size_t most_references = 4 * most_parts;
    const auto root = solid_.gates.empty() ? 0u : leaves_;  // gates come after their parents
    require(root);
    for (;;) {
      const bool alive = follow();
      if (steps_left_ == 0) return false;
      if (alive) emit();
      if (products_.list.size() > most_parts || products_.leaves.size() > most_references)
        return false;
      if (!turn_back()) break;
    }
    products_.hierarchy = Hierarchy<T>(envelopes_);
    return true;
  }

 private:
  // Nodes to be looked at, by when: a list for each, that branches share.
  enum Turn : std::uint8_t { leaf_turn, gate_turn, cutting_turn, choice_turn, kTurns };
  struct Pending {
    std::uint32_t node;
    std::int32_t next;
  };
  // What a conjunction consists of besides the list of pending nodes' cells.
  struct State {
    Bounds<T> box = everything<T>();
    std::array<std::int32_t, kTurns> pending{kEnd, kEnd, kEnd, kEnd};
    bool swept = false;  // the cutters of the gates chosen so far are in it
    std::size_t positives = 0, negatives = 0, cells = 0;
  };
  // A gate of `any` with its inputs [next, end) of choices_ not tried yet.
  struct Fork {
    State state;
    std::size_t begin, next;
  };
  // A gate's inputs, and a hierarchy over them once they are asked for again.
  struct Fan {
    std::uint32_t begin = 0, end = 0;   // of inputs_
    std::uint32_t first = 0, last = 0;  // leaves below it are [first, last)
    std::int32_t asked = 0;
    std::int32_t hierarchy = kEnd;  // index into hierarchies_
  };

  bool is_leaf(std::uint32_t node) const { return node < leaves_; }
  Fan& fan(std::uint32_t gate) { return fans_[gate - leaves_]; }
  bool takes_all(std::uint32_t gate) const { return solid_.gates[gate - leaves_].needed > 1; }

  void link(std::span<const Bounds<T>>);
  void measure(std::span<const Bounds<T>> boxes);
  void gather_cutters();

  void push(Turn turn, std::uint32_t node) {
    cells_.push_back({node, now_.pending[turn]});
    now_.pending[turn] = static_cast<std::int32_t>(cells_.size()) - 1;
  }

  // Adds to the conjunction a node that may hold points of its box.
  void require(std::uint32_t node) {
    const bool bounded = nodes_[node].bounded;
    if (is_leaf(node)) {
      if (bounded) push(leaf_turn, node);
      else negatives_.push_back(node);
    } else if (bounded) {
      push(gate_turn, node);
    } else {
      push(takes_all(node) ? cutting_turn : choice_turn, node);
    }
  }

  bool step() { return steps_left_ > 0 && --steps_left_ > 0; }
  bool near(const Bounds<T>& box) const { return box.near(now_.box, products_.gap); }

  // Works off what is pending, the first input of every choice; false where nothing
  // can be left of it.
  bool follow() {
    for (;;) {
      if (!step()) return false;
      int turn = 0;
      // The gates' own cutters have their turn once all that is bounded is known.
      while (turn < kTurns && now_.pending[static_cast<std::size_t>(turn)] == kEnd &&
             (turn != cutting_turn || now_.swept))
        ++turn;
      if (turn == kTurns) return true;
      if (turn == cutting_turn && !now_.swept) {
        now_.swept = true;
        sweep();
        continue;
      }
      std::int32_t& head = now_.pending[static_cast<std::size_t>(turn)];
      const std::uint32_t node = cells_[static_cast<std::size_t>(head)].node;
      head = cells_[static_cast<std::size_t>(head)].next;
      if (turn <= gate_turn) {
        if (!near(nodes_[node].box)) return false;
        if (turn == leaf_turn) {
          positives_.push_back(node);
          now_.box = common(now_.box, nodes_[node].box);
        } else if (takes_all(node)) {
          require_all(node);
        } else if (!choose(node)) {
          return false;
        }
      } else if (turn == cutting_turn) {
        for_each_input_near(node, [&](std::uint32_t input) { require(input); });
      } else if (near(nodes_[node].box) && !choose(node)) {
        return false;
      }
    }
  }

  // A bounded gate of `all`: its inputs that are bounded; the others are cutters.
  void require_all(std::uint32_t gate) {
    const Fan& inputs = fan(gate);
    for (std::uint32_t i = inputs.begin; i < inputs.end && step(); ++i)
      if (nodes_[inputs_[i]].bounded) require(inputs_[i]);
    // One that was chosen late brings its cutters with it.
    if (now_.swept) push(cutting_turn, gate);
  }

  // Opens a gate of `any`; false where none of its inputs comes near.
  bool choose(std::uint32_t gate) {
    const std::size_t begin = choices_.size();
    for_each_input_near(
        gate, [&](std::uint32_t input) { choices_.push_back(input); }, true);
    if (choices_.size() == begin) return false;
    if (choices_.size() - begin > 1) {
      State kept = now_;
      kept.positives = positives_.size();
      kept.negatives = negatives_.size();
      kept.cells = cells_.size();
      forks_.push_back({kept, begin, begin + 1});
      require(choices_[begin]);
    } else {
      const std::uint32_t only = choices_.back();
      choices_.pop_back();
      require(only);
    }
    return true;
  }

  // Goes on with the last choice that is not exhausted; false where there is none.
  bool turn_back() {
    if (forks_.empty()) return false;
    Fork& fork = forks_.back();
    now_ = fork.state;
    positives_.resize(now_.positives);
    negatives_.resize(now_.negatives);
    cells_.resize(now_.cells);
    const std::uint32_t node = choices_[fork.next++];
    if (fork.next == choices_.size()) {
      choices_.resize(fork.begin);
      forks_.pop_back();
    }
    require(node);
    return true;
  }

  // The inputs that matter within the conjunction's box. Of a gate of `all` only those
  // that are not bounded.
  template <typename Visit>
  void for_each_input_near(std::uint32_t gate, Visit&& visit, bool bounded_too = false) {
    Fan& inputs = fan(gate);
    const auto see = [&](std::uint32_t input) {
      const Node<T>& node = nodes_[input];
      if ((bounded_too || !node.bounded) && near(node.box)) visit(input);
    };
    constexpr std::uint32_t kFew = 8;
    if (inputs.end - inputs.begin <= kFew || inputs.asked++ == 0) {
      for (std::uint32_t i = inputs.begin; i < inputs.end && step(); ++i) see(inputs_[i]);
      return;
    }
    if (inputs.hierarchy == kEnd) {
      std::vector<Bounds<T>> boxes;
      for (std::uint32_t i = inputs.begin; i < inputs.end; ++i)
        boxes.push_back(nodes_[inputs_[i]].box);
      inputs.hierarchy = static_cast<std::int32_t>(hierarchies_.size());
      hierarchies_.emplace_back(boxes);
    }
    hierarchies_[static_cast<std::size_t>(inputs.hierarchy)].for_each_near(
        now_.box, products_.gap, [&](std::uint32_t i) {
          see(inputs_[inputs.begin + i]);
          return !step();
        });
  }

  // What the chosen gates of `all` cut away here: a gate was chosen if a positive is
  // below it. Found in one search, so that a chain of a thousand cuts is no walk of a
  // thousand steps for each part.
  void sweep() {
    cutters_.for_each_near(now_.box, products_.gap, [&](std::uint32_t i) {
      const auto [node, gate] = cutter_of_[i];
      const Fan& range = fan(gate);
      const bool chosen =
          std::any_of(positives_.begin(), positives_.end(),
                      [&](std::uint32_t leaf) { return leaf >= range.first && leaf < range.last; });
      if (chosen) require(node);
      return !step();
    });
  }

  void emit() {
    Bounds<T> box = now_.box;
    ProductRange product{static_cast<std::uint32_t>(products_.leaves.size()),
                         static_cast<std::uint32_t>(positives_.size()), 0};
    products_.leaves.insert(products_.leaves.end(), positives_.begin(), positives_.end());
    for (const std::uint32_t leaf : negatives_) {
      if (!near(nodes_[leaf].box)) continue;
      products_.leaves.push_back(leaf);
      ++product.negatives;
    }
    products_.list.push_back(product);
    for (int axis = 0; axis < 3; ++axis)  // of two that just do not meet
      if (box.low[axis] > box.high[axis]) std::swap(box.low[axis], box.high[axis]);
    envelopes_.push_back(box);
  }

  const Solid<T>& solid_;
  const std::uint32_t leaves_;
  std::vector<Node<T>> nodes_;  // leaves, then gates
  std::vector<Fan> fans_;
  std::vector<std::uint32_t> inputs_;
  struct Cutter {
    std::uint32_t node, gate;
  };
  std::vector<Cutter> cutter_of_;
  Hierarchy<T> cutters_;
  std::vector<Hierarchy<T>> hierarchies_;

  State now_;
  std::vector<Pending> cells_;
  std::vector<std::uint32_t> positives_, negatives_, choices_;
  std::vector<Fork> forks_;

  Products<T>& products_;
  std::vector<Bounds<T>> envelopes_;
  std::size_t steps_left_;
};

template <typename T>
void Distributor<T>::link(std::span<const Bounds<T>>) {
  const auto parent_of = [&](std::uint32_t node) {
    return is_leaf(node) ? solid_.leaves[node].gate : solid_.gates[node - leaves_].parent;
  };
  const auto count = static_cast<std::uint32_t>(nodes_.size());
  for (std::uint32_t node = 0; node < count; ++node)
    if (parent_of(node) >= 0) ++fans_[static_cast<std::size_t>(parent_of(node))].end;
  std::uint32_t total = 0;
  for (Fan& each : fans_) {
    each.begin = total;
    total += each.end;
    each.end = each.begin;
  }
  inputs_.resize(total);
  for (std::uint32_t node = 0; node < count; ++node)
    if (parent_of(node) >= 0)
      inputs_[fans_[static_cast<std::size_t>(parent_of(node))].end++] = node;
}

// Boxes from the leaves up: parents come before their children in the list of gates.
template <typename T>
void Distributor<T>::measure(std::span<const Bounds<T>> boxes) {
  for (std::uint32_t leaf = 0; leaf < leaves_; ++leaf)
    nodes_[leaf] = {boxes[leaf], !solid_.leaves[leaf].complemented};
  for (auto gate = static_cast<std::uint32_t>(nodes_.size()); gate-- > leaves_;) {
    Fan& inputs = fan(gate);
    const bool all = takes_all(gate);
    // Of `all` what is bounded decides, of `any` what is not.
    Bounds<T> meet = everything<T>(), join;
    bool decided = false;
    inputs.first = leaves_;
    inputs.last = 0;
    for (std::uint32_t i = inputs.begin; i < inputs.end; ++i) {
      const std::uint32_t input = inputs_[i];
      const Node<T>& node = nodes_[input];
      if (node.bounded == all) {
        decided = true;
        meet = common(meet, node.box);
      }
      join.include(node.box);
      inputs.first = std::min(inputs.first, is_leaf(input) ? input : fan(input).first);
      inputs.last = std::max(inputs.last, is_leaf(input) ? input + 1 : fan(input).last);
    }
    nodes_[gate] = {decided ? meet : join, decided == all};
  }
}

template <typename T>
void Distributor<T>::gather_cutters() {
  std::vector<Bounds<T>> boxes;
  for (auto gate = leaves_; gate < nodes_.size(); ++gate) {
    if (!nodes_[gate].bounded || !takes_all(gate)) continue;
    for (std::uint32_t i = fan(gate).begin; i < fan(gate).end; ++i) {
      if (nodes_[inputs_[i]].bounded) continue;
      cutter_of_.push_back({inputs_[i], gate});
      boxes.push_back(nodes_[inputs_[i]].box);
    }
  }
  cutters_ = Hierarchy<T>(boxes);
}

}  // namespace

template <typename T>
Products<T> build_products(const Solid<T>& solid, std::span<const Bounds<T>> boxes) {
  Products<T> products;
  const Bounds<T> all = solid.hierarchy.bounds();
  const auto extent = all.high - all.low;
  // Between what rays from near the solid take for one event and what is apart for
  // envelopes: half of the digits, and some.
  products.gap = 16 * std::sqrt(Numeric<T>::kEpsilon) * std::max({extent.x, extent.y, extent.z});
  if (!std::isfinite(products.gap)) products.gap = 0;
  products.crowd = static_cast<std::uint32_t>(solid.leaves.size());
  // Where a T is fine enough to tell as many events apart as there are, that will do.
  if (static_cast<T>(products.crowd) * Numeric<T>::kEpsilon > Numeric<T>::kFineChain)
    products.crowd = std::min(products.crowd, crowd_of(solid.hierarchy, products.gap));
  products.complete = Distributor<T>(solid, boxes, products).run();
  if (!products.complete) {
    products.list = {};
    products.leaves = {};
  }
  return products;
}

template Products<float> build_products(const Solid<float>&, std::span<const Bounds<float>>);
template Products<double> build_products(const Solid<double>&, std::span<const Bounds<double>>);
template Products<long double> build_products(const Solid<long double>&,
                                              std::span<const Bounds<long double>>);

}  // namespace sir
