// A change of one node of a tree of composition, in place. The thesis takes the tree apart for it
// (desfaz, 3.2.2.6), transforms the part (3.2.2.2) and combines all of it again (3.2.2.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "modeler/node.h"
#include "modeler/step.h"

namespace sir::modeler {

/// New surface numbers: one for all faces, or one for each; of a composite one for all that is in
/// it.
struct Paint {
  std::vector<std::int64_t> surfaces;
};

/// Another name for the node.
struct Label {
  std::string text;
};

/// A Step is appended to every LOCAL_CENA at and below the node; an Operation takes the place of a
/// composite's.
using NodeChange = std::variant<Step, Paint, Label, Operation>;

struct Edit {
  std::size_t place = 0;  ///< of the node in preorder(); 0: the root
  NodeChange change;
  bool apart = false;         ///< bounds need not meet (see edited)
  bool about_centre = false;  ///< what turns or scales a primitive is about its bounds' centre too
};

/// The tree after an edit: what splitting it down to the node, changing that and combining again
/// would give, names and file slots kept. The nodes on the way are made anew, and those at and
/// below the place that change; all others are shared. Throws CommandError where the change cannot
/// be done, would make a matrix singular or its numbers too large, or gives a composite that is not
/// a union an operation or a part such that its parts' bounds do not meet any more (with `apart`
/// they need not).
NodePtr edited(const NodePtr& tree, const Edit& edit);

/// The same for one edit after the other; those of the whole in one go.
NodePtr edited(NodePtr tree, std::span<const Edit* const> edits);

/// A primitive with new surface numbers. Throws CommandError where there are neither one nor as
/// many as it has faces.
Primitive painted(Primitive primitive, const std::vector<std::int64_t>& surfaces);

/// Refuses a difference or an intersection of solids whose bounds do not meet ("não há interseção
/// entre os sólidos", 3.2.2.3); the names are for the message.
void require_meeting(Operation operation, std::string_view left_name, const Box& left,
                     std::string_view right_name, const Box& right);

}  // namespace sir::modeler
