#include "modeler/node.h"

#include <algorithm>
#include <utility>

namespace sir::modeler {
namespace {

Box bounds_of(const Primitive& primitive) {
  LocalCena<double> way;
  way.linear = primitive.local_cena.linear;
  way.translation = primitive.local_cena.translation;
  return tight_bounds_of(primitive.kind, way);
}

// Takes the children out of a node that is about to go.
void release_children(Node& node, std::vector<NodePtr>& released) {
  auto* composite = std::get_if<Composite>(&node.what);
  if (composite == nullptr) return;
  for (NodePtr* child : {&composite->left, &composite->right})
    if (*child) released.push_back(std::move(*child));
}

}  // namespace

Node::Node(std::string its_name, Primitive primitive, FileSlot its_slot)
    : name(std::move(its_name)),
      slot(its_slot),
      what(std::move(primitive)),
      bounds(bounds_of(std::get<Primitive>(what))),
      count(1) {}

Node::Node(std::string its_name, Composite composite, FileSlot its_slot)
    : name(std::move(its_name)),
      slot(its_slot),
      what(std::move(composite)),
      bounds(combined(this->composite()->operation, this->composite()->left->bounds,
                      this->composite()->right->bounds)),
      count(1 + this->composite()->left->count + this->composite()->right->count) {}

Node::~Node() {
  // A child that goes with its parent gives up its own children first: no destructor is ever
  // called within more than one other.
  std::vector<NodePtr> released;
  release_children(*this, released);
  while (!released.empty()) {
    const NodePtr node = std::move(released.back());
    released.pop_back();
    // Nodes are made by make_node(), as objects that are not const.
    if (node.use_count() == 1) release_children(const_cast<Node&>(*node), released);
  }
}

NodePtr make_node(std::string name, Primitive primitive, FileSlot slot) {
  return std::make_shared<Node>(std::move(name), std::move(primitive), slot);
}

NodePtr make_node(std::string name, Composite composite, FileSlot slot) {
  return std::make_shared<Node>(std::move(name), std::move(composite), slot);
}

NodePtr renamed(const Node& node, std::string name) {
  if (const Primitive* primitive = node.primitive())
    return make_node(std::move(name), *primitive, node.slot);
  return make_node(std::move(name), *node.composite(), node.slot);
}

NodePtr renumbered(const Node& node, FileSlot slot) {
  if (const Primitive* primitive = node.primitive()) return make_node(node.name, *primitive, slot);
  return make_node(node.name, *node.composite(), slot);
}

const Node* node_at(const Node& tree, std::size_t place) {
  if (place >= tree.count) return nullptr;
  const Node* node = &tree;
  while (place > 0) {
    const Composite& composite = *node->composite();
    --place;
    const bool left = place < composite.left->count;
    if (!left) place -= composite.left->count;
    node = left ? composite.left.get() : composite.right.get();
  }
  return node;
}

std::vector<const Node*> preorder(const Node& tree) {
  std::vector<const Node*> nodes, open{&tree};
  nodes.reserve(tree.count);
  while (!open.empty()) {
    const Node* node = open.back();
    open.pop_back();
    nodes.push_back(node);
    if (const Composite* composite = node->composite()) {
      open.push_back(composite->right.get());
      open.push_back(composite->left.get());
    }
  }
  return nodes;
}

Box combined(Operation operation, const Box& left, const Box& right) {
  Box box = left;
  switch (operation) {
    case Operation::union_of: box.include(right); break;
    case Operation::difference: break;
    case Operation::intersection:
      box.low = glm::max(left.low, right.low);
      box.high = glm::min(left.high, right.high);
      if (is_empty(box)) box = {};
      break;
  }
  return box;
}

bool meet(const Box& a, const Box& b) { return a.near(b, 0.0); }

bool is_empty(const Box& box) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(box.low[axis] <= box.high[axis])) return true;
  return false;
}

}  // namespace sir::modeler
