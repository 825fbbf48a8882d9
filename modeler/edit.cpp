#include "modeler/edit.h"

#include <utility>

#include "modeler/command_error.h"
#include "modeler/operations.h"
#include "tracer/names.h"
#include "tracer/text_file.h"

namespace sir::modeler {
namespace {

Primitive transformed(const Node& node, const Primitive& primitive,
                      std::span<const Step* const> steps) {
  Primitive result = primitive;
  for (const Step* step : steps) result.local_cena = appended(result.local_cena, *step);
  if (!is_usable(result.local_cena))
    throw CommandError("that would make the matrix of " + in_quotes(node.name) +
                       " singular, or its numbers too large");
  return result;
}

// A tree with every primitive replaced by what `change` makes of it; names and slots stay.
template <typename Change>
NodePtr with_primitives(const Node& tree, Change change) {
  const std::vector<const Node*> nodes = preorder(tree);
  // Backwards every node comes after its children, the left one last.
  std::vector<NodePtr> done;
  for (auto at = nodes.rbegin(); at != nodes.rend(); ++at) {
    const Node& node = **at;
    if (const Primitive* primitive = node.primitive()) {
      done.push_back(make_node(node.name, change(node, *primitive), node.slot));
      continue;
    }
    NodePtr left = std::move(done.back());
    done.pop_back();
    done.back() = make_node(
        node.name, Composite{node.composite()->operation, std::move(left), std::move(done.back())},
        node.slot);
  }
  return std::move(done.back());
}

NodePtr transformed(const Node& tree, std::span<const Step* const> steps) {
  return with_primitives(tree, [&](const Node& node, const Primitive& primitive) {
    return transformed(node, primitive, steps);
  });
}

// The node itself, changed.
NodePtr changed(const Node& node, const NodeChange& change, bool apart) {
  if (const Step* step = std::get_if<Step>(&change)) return transformed(node, {&step, 1});
  if (const Label* label = std::get_if<Label>(&change)) {
    require_label(label->text);
    return renamed(node, label->text);
  }
  const Composite* composite = node.composite();
  if (const Paint* paint = std::get_if<Paint>(&change)) {
    if (composite != nullptr && paint->surfaces.size() != 1)
      throw CommandError(in_quotes(node.name) +
                         " is a composite: it takes 1 surface number for all that is in it; " +
                         std::to_string(paint->surfaces.size()) + " given");
    return with_primitives(node, [&](const Node&, const Primitive& primitive) {
      return painted(primitive, paint->surfaces);
    });
  }
  if (composite == nullptr) throw CommandError(in_quotes(node.name) + " is not a composite");
  const Operation operation = std::get<Operation>(change);
  if (!apart)
    require_meeting(operation, composite->left->name, composite->left->bounds,
                    composite->right->name, composite->right->bounds);
  return make_node(node.name, Composite{operation, composite->left, composite->right}, node.slot);
}

// A composite, and which of its parts the way takes: a node may be both of them.
struct Fork {
  const Node* node;
  bool left;
};

// The forks from the root on to the node at a place.
std::vector<Fork> way_to(const Node& tree, std::size_t place, const Node*& end) {
  std::vector<Fork> way;
  end = &tree;
  while (place > 0) {
    const Composite& composite = *end->composite();
    const std::size_t before = composite.left->count;
    way.push_back({end, place <= before});
    end = (way.back().left ? composite.left : composite.right).get();
    place -= way.back().left ? 1 : 1 + before;
  }
  return way;
}

}  // namespace

NodePtr edited(const NodePtr& tree, const Edit& edit) {
  const Node* node = nullptr;
  const std::vector<Fork> way = way_to(*tree, edit.place, node);
  NodePtr part = changed(*node, edit.change, edit.apart);
  for (auto fork = way.rbegin(); fork != way.rend(); ++fork) {
    Composite composite = *fork->node->composite();
    const auto& [operation, left, right] = composite;
    // Parts that were apart before have been allowed to be.
    const bool must_meet = !edit.apart && meet(left->bounds, right->bounds);
    (fork->left ? composite.left : composite.right) = std::move(part);
    if (must_meet) require_meeting(operation, left->name, left->bounds, right->name, right->bounds);
    part = make_node(fork->node->name, std::move(composite), fork->node->slot);
  }
  return part;
}

NodePtr edited(NodePtr tree, std::span<const Edit* const> edits) {
  std::vector<const Step*> steps;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const Step* step = std::get_if<Step>(&edits[i]->change);
    if (edits[i]->place == 0 && step != nullptr) {
      steps.push_back(step);
      continue;
    }
    if (!steps.empty()) tree = transformed(*tree, std::exchange(steps, {}));
    tree = edited(tree, *edits[i]);
  }
  return steps.empty() ? tree : transformed(*tree, steps);
}

Primitive painted(Primitive primitive, const std::vector<std::int64_t>& surfaces) {
  const auto faces = static_cast<std::size_t>(face_count(primitive.kind));
  if (surfaces.size() != 1 && surfaces.size() != faces)
    throw CommandError(
        "a " + std::string(name_of(primitive.kind)) + " takes 1 surface number" +
        (faces > 1 ? " for all faces or " + std::to_string(faces) + ", one per face" : "") + "; " +
        std::to_string(surfaces.size()) + " given");
  primitive.surface_per_face = surfaces.size() > 1;
  for (std::size_t face = 0; face < faces; ++face)
    primitive.surfaces[face] = surfaces[primitive.surface_per_face ? face : 0];
  return primitive;
}

void require_meeting(Operation operation, std::string_view left_name, const Box& left,
                     std::string_view right_name, const Box& right) {
  if (operation == Operation::union_of || meet(left, right)) return;
  throw CommandError(
      "there is no intersection between " + in_quotes(left_name) + " and " + in_quotes(right_name) +
      ": their bounds do not meet, so the " + std::string(name_of(operation)) +
      (operation == Operation::intersection ? " would be empty" : " would take nothing away"));
}

}  // namespace sir::modeler
