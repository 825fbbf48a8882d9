// A solid of the list: its tree, and how it came about by transforms (thesis 3.2.2.2), so that
// undo without limit does not keep a tree for every one of them.
#pragma once

#include <memory>
#include <string>

#include "modeler/node.h"
#include "modeler/step.h"

namespace sir::modeler {

/// Its value never changes. The tree is kept, or worked out again, from an earlier one by at most
/// kMostSteps transforms, where it is asked for. For one thread; trees may be handed to others.
class Solid {
 public:
  static constexpr int kMostSteps = 64;

  explicit Solid(NodePtr tree);

  /// The root, with all that hangs on it.
  const NodePtr& tree() const;

  /// The solid with every primitive transformed, LOCAL_CENA T. Throws CommandError where a matrix
  /// would become singular or its numbers too large.
  Solid transformed(const Step& step) const;

  /// Lets go of the tree where it can be worked out again.
  void forget_tree() const;

 private:
  struct Path {
    Step step;
    std::shared_ptr<const Path> before;
  };
  NodePtr base_;
  std::shared_ptr<const Path> path_;  // from the base; null: the base is the tree
  int steps_ = 0;
  mutable NodePtr tree_;  // null: to be worked out
};

/// A tree with every primitive transformed; names and numbers stay. Throws as above.
NodePtr transformed(const Node& tree, const Step& step);

}  // namespace sir::modeler
