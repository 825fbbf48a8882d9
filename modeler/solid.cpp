#include "modeler/solid.h"

#include <utility>
#include <vector>

#include "modeler/command_error.h"
#include "tracer/text_file.h"

namespace sir::modeler {
namespace {

Primitive transformed(const Node& node, const Primitive& primitive, const Step& step) {
  Primitive result = primitive;
  result.local_cena = appended(primitive.local_cena, step);
  if (!is_usable(result.local_cena))
    throw CommandError("that would make the matrix of " + in_quotes(node.name) +
                       " singular, or its numbers too large");
  return result;
}

}  // namespace

NodePtr transformed(const Node& tree, const Step& step) {
  const std::vector<const Node*> nodes = preorder(tree);
  // Backwards every node comes after its children, the left one last.
  std::vector<NodePtr> done;
  for (auto at = nodes.rbegin(); at != nodes.rend(); ++at) {
    const Node& node = **at;
    if (const Primitive* primitive = node.primitive()) {
      done.push_back(make_node(node.name, transformed(node, *primitive, step), node.slot));
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

Solid::Solid(NodePtr tree) : base_(tree), tree_(std::move(tree)) {}

const NodePtr& Solid::tree() const {
  if (!tree_) {
    std::vector<const Path*> steps;
    for (const Path* at = path_.get(); at != nullptr; at = at->before.get()) steps.push_back(at);
    NodePtr tree = base_;
    for (auto at = steps.rbegin(); at != steps.rend(); ++at)
      tree = modeler::transformed(*tree, (*at)->step);
    tree_ = std::move(tree);
  }
  return tree_;
}

Solid Solid::transformed(const Step& step) const {
  NodePtr result = modeler::transformed(*tree(), step);
  // A primitive is no larger than the way to it.
  if (result->primitive() != nullptr) return Solid(std::move(result));
  Solid solid(steps_ < kMostSteps ? base_ : tree());
  const bool goes_on = steps_ < kMostSteps;
  solid.path_ = std::make_shared<const Path>(Path{step, goes_on ? path_ : nullptr});
  solid.steps_ = goes_on ? steps_ + 1 : 1;
  solid.tree_ = std::move(result);
  return solid;
}

void Solid::forget_tree() const {
  if (path_) tree_.reset();
}

}  // namespace sir::modeler
