#include "modeler/csg.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace sir::modeler {
namespace {

// Whether all have one, and no two the same.
bool distinct(const std::vector<const Node*>& nodes, std::int64_t FileSlot::*which) {
  std::vector<std::int64_t> values;
  for (const Node* node : nodes) {
    if (node->slot.*which == FileSlot::kNone) return false;
    values.push_back(node->slot.*which);
  }
  std::sort(values.begin(), values.end());
  return std::adjacent_find(values.begin(), values.end()) == values.end();
}

// `nodes` as they stand in the tree now.
void put_in_order(CsgTree& tree, const std::vector<const Node*>& nodes,
                  std::int64_t FileSlot::*which) {
  std::vector<std::size_t> order(tree.nodes.size()), place(tree.nodes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return nodes[a]->slot.*which < nodes[b]->slot.*which;
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
  const bool own_numbers = distinct(nodes, &FileSlot::number);
  CsgTree tree;
  tree.nodes.resize(nodes.size());
  bool some = false;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& from = *nodes[i];
    CsgNode& node = tree.nodes[i];
    some = some || from.slot.number != FileSlot::kNone;
    node.number = own_numbers ? from.slot.number : static_cast<std::int64_t>(i) + 1;
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
  if (own_numbers)
    put_in_order(tree, nodes,
                 distinct(nodes, &FileSlot::position) ? &FileSlot::position : &FileSlot::number);
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
  bool as_they_come = true, by_number = true;
  for (std::size_t i = 0; i < order.size(); ++i) {
    as_they_come =
        as_they_come && order[i] == i && tree.nodes[i].number == static_cast<std::int64_t>(i) + 1;
    by_number = by_number && (i == 0 || tree.nodes[i - 1].number < tree.nodes[i].number);
  }
  // Backwards every node comes after its children, the left one last.
  std::vector<NodePtr> done;
  for (auto at = order.rbegin(); at != order.rend(); ++at) {
    const CsgNode& node = tree.nodes[*at];
    FileSlot slot;
    if (!as_they_come) slot.number = node.number;
    if (!by_number) slot.position = static_cast<std::int64_t>(*at);
    if (!node.composite) {
      done.push_back(make_node(
          node.name, Primitive{node.kind, node.surfaces, node.surface_per_face, node.placement},
          slot));
      continue;
    }
    NodePtr left = std::move(done.back());
    done.pop_back();
    done.back() = make_node(
        node.name, Composite{node.operation, std::move(left), std::move(done.back())}, slot);
  }
  return std::move(done.back());
}

}  // namespace sir::modeler
