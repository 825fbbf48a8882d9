// A solid of the list: its tree, and how it came about by edits (thesis 3.2.2.2), so that undo
// without limit does not keep a tree for every one of them.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "modeler/edit.h"
#include "modeler/node.h"

namespace sir::modeler {

/// Its value never changes. The tree is kept, or worked out again where it is asked for, from an
/// earlier one by at most most_steps() edits; after translations of a composite it is worked out
/// only then. For one thread; trees may be handed to others.
class Solid {
 public:
  static constexpr int kMostSteps = 64;

  explicit Solid(NodePtr tree);

  /// The root, with all that hangs on it.
  const NodePtr& tree() const;

  /// Whether the root is one; asks for no tree.
  bool composite() const { return base_->composite() != nullptr; }

  /// The solid after an edit; its place is in the tree. Throws as modeler::edited() does.
  Solid edited(Edit edit) const;

  /// Lets go of the tree where it can be worked out again.
  void forget_tree() const;

  /// About how many nodes would have to be made for the tree then, and how many it has.
  std::size_t work() const { return steps_ * base_->count; }
  std::size_t count() const { return base_->count; }

  /// After so many edits of a tree of so many nodes it is kept: kMostSteps, and of larger trees,
  /// which cost memory, more, as long as the work is done in some hundredths of a second.
  static std::size_t most_steps(std::size_t nodes);

 private:
  struct Path {
    Edit edit;
    std::shared_ptr<const Path> before;
  };
  bool bears(const glm::dvec3& way) const;

  NodePtr base_;
  std::shared_ptr<const Path> path_;  // from the base; null: the base is the tree
  std::size_t steps_ = 0;             // of the path
  mutable NodePtr near_;              // the tree, or an earlier one to work it out from
  mutable std::shared_ptr<const Path> near_path_;  // so far as that one has come
  mutable std::optional<double> reach_;            // no translation of a primitive is longer
};

}  // namespace sir::modeler
