#include "modeler/csg.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace sir::modeler {
namespace {

// Whether all numbers are given, and no two the same.
bool numbered(const std::vector<const Node*>& nodes) {
  std::vector<std::int64_t> numbers;
  for (const Node* node : nodes) {
    if (node->number == Node::kNoNumber) return false;
    numbers.push_back(node->number);
  }
  std::sort(numbers.begin(), numbers.end());
  return std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end();
}

void put_in_order_of_numbers(CsgTree& tree) {
  std::vector<std::size_t> order(tree.nodes.size()), place(tree.nodes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return tree.nodes[a].number < tree.nodes[b].number;
  });
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  CsgTree sorted;
  sorted.root = place[tree.root];
  sorted.nodes.reserve(order.size());
  for (const std::size_t from : order) {
    CsgNode& node = sorted.nodes.emplace_back(std::move(tree.nodes[from]));
    if (!node.composite) continue;
    node.left = place[node.left];
    node.right = place[node.right];
  }
  tree = std::move(sorted);
}

}  // namespace

CsgTree to_csg(const Node& root, bool* numbers_lost) {
  const std::vector<const Node*> nodes = preorder(root);
  const bool own_numbers = numbered(nodes);
  CsgTree tree;
  tree.nodes.resize(nodes.size());
  bool some = false;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& from = *nodes[i];
    CsgNode& node = tree.nodes[i];
    some = some || from.number != Node::kNoNumber;
    node.number = own_numbers ? from.number : static_cast<std::int64_t>(i) + 1;
    node.name = from.name;
    if (const Composite* composite = from.composite()) {
      node.composite = true;
      node.operation = composite->operation;
      node.left = i + 1;
      node.right = i + 1 + composite->left->count;
      continue;
    }
    const Primitive& primitive = *from.primitive();
    node.kind = primitive.kind;
    node.surfaces = primitive.surfaces;
    node.surface_per_face = primitive.surface_per_face;
    node.placement = primitive.local_cena;
  }
  if (numbers_lost != nullptr) *numbers_lost = some && !own_numbers;
  if (own_numbers) put_in_order_of_numbers(tree);
  return tree;
}

NodePtr from_csg(const CsgTree& tree) {
  std::vector<std::size_t> order, open{tree.root};
  while (!open.empty()) {
    const std::size_t index = open.back();
    open.pop_back();
    order.push_back(index);
    const CsgNode& node = tree.nodes[index];
    if (!node.composite) continue;
    open.push_back(node.right);
    open.push_back(node.left);
  }
  bool own_numbers = false;
  for (std::size_t i = 0; i < order.size(); ++i)
    own_numbers = own_numbers || tree.nodes[order[i]].number != static_cast<std::int64_t>(i) + 1;
  // Backwards every node comes after its children, the left one last.
  std::vector<NodePtr> done;
  for (auto at = order.rbegin(); at != order.rend(); ++at) {
    const CsgNode& node = tree.nodes[*at];
    const std::int64_t number = own_numbers ? node.number : Node::kNoNumber;
    if (!node.composite) {
      done.push_back(make_node(
          node.name, Primitive{node.kind, node.surfaces, node.surface_per_face, node.placement},
          number));
      continue;
    }
    NodePtr left = std::move(done.back());
    done.pop_back();
    done.back() = make_node(
        node.name, Composite{node.operation, std::move(left), std::move(done.back())}, number);
  }
  return std::move(done.back());
}

}  // namespace sir::modeler
