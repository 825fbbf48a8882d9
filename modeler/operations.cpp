#include "modeler/operations.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modeler/command_error.h"
#include "modeler/nearest_name.h"
#include "tracer/limits.h"
#include "tracer/text_file.h"

namespace sir::modeler {
namespace {

EntryPtr entry(std::string name, Solid solid) {
  return std::make_shared<const Entry>(Entry{std::move(name), std::move(solid), false});
}

EntryPtr entry(std::string name, NodePtr tree) {
  return entry(std::move(name), Solid(std::move(tree)));
}

void require_free(const Lsu& solids, const std::string& name) {
  require_name(name);
  if (solids.find(name)) throw CommandError("a solid " + in_quotes(name) + " exists already");
}

Changes added(const Lsu& solids, EntryPtr added) {
  return {{solids.free_place(), nullptr, std::move(added)}};
}

Changes replaced(const Lsu& solids, const EntryPtr& before, EntryPtr after) {
  return {{solids.place_of(before->name), before, std::move(after)}};
}

bool is_finite(const Box& box) {
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(box.low[axis]) || !std::isfinite(box.high[axis])) return false;
  return true;
}

bool is_white(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

bool turns_or_scales(const Step& step) {
  return step.kind == Step::Kind::scale || step.kind == Step::Kind::rotation;
}

glm::dvec3 centre_of(const Box& bounds, std::string_view name) {
  if (is_empty(bounds) || !is_finite(bounds))
    throw CommandError("the bounds of " + in_quotes(name) + " have no centre to transform about" +
                       (is_empty(bounds) ? ": the solid is empty" : ""));
  return bounds.centre();
}

}  // namespace

void require_label(std::string_view text) {
  if (text.empty()) throw CommandError("a solid's name cannot be empty");
  if (is_white(text.front()) || is_white(text.back()))
    throw CommandError("the name " + in_quotes(text) +
                       " begins or ends in white space, which the .CSG does not keep");
}

void require_name(std::string_view name) {
  require_label(name);
  for (std::size_t i = 0; i < name.size(); ++i)
    if (static_cast<unsigned char>(name[i]) < 0x20 || name[i] == 0x7F)
      throw CommandError("the name " + in_quotes(name) +
                         " holds a control character; only a label may");
}

EntryPtr require(const Lsu& solids, std::string_view name) {
  if (EntryPtr found = solids.find(name)) return found;
  std::string reason = "there is no solid " + in_quotes(name);
  if (solids.empty()) throw CommandError(reason + ": the list of solids is empty");
  NearestName nearest(name);
  for (const auto& [place, candidate] : solids.entries()) nearest.offer(candidate->name);
  if (nearest.found()) reason += "; did you mean " + in_quotes(nearest.name()) + "?";
  throw CommandError(reason);
}

std::string free_name(const Lsu& solids, const std::string& name, std::string_view besides) {
  const auto numbered = [&](std::uint64_t number) {
    return name + " (" + std::to_string(number) + ")";
  };
  const auto is_free = [&](const std::string& candidate) {
    return !solids.find(candidate) && candidate != besides;
  };
  if (is_free(name)) return name;
  // Thousands of copies may have been taken apart: by doubling, then between the last two.
  std::uint64_t taken = 1, free = 2;
  while (!is_free(numbered(free))) {
    taken = free;
    free *= 2;
  }
  while (free - taken > 1) {
    const std::uint64_t middle = taken + (free - taken) / 2;
    (is_free(numbered(middle)) ? free : taken) = middle;
  }
  return numbered(free);
}

Changes create(const Lsu& solids, const std::string& name, PrimitiveKind kind,
               const std::vector<std::int64_t>& surfaces) {
  require_free(solids, name);
  Primitive primitive;
  primitive.kind = kind;
  return added(solids, entry(name, make_node(name, painted(primitive, surfaces))));
}

Changes edit(const Lsu& solids, std::string_view name, Edit edit) {
  const EntryPtr solid = require(solids, name);
  if (Step* step = std::get_if<Step>(&edit.change); step != nullptr && turns_or_scales(*step)) {
    const Node& node = *node_at(*solid->solid.tree(), edit.place);
    if (node.composite() != nullptr || edit.about_centre)
      step->centre = centre_of(node.bounds, edit.place > 0 ? node.name : name);
  }
  return replaced(solids, solid, entry(solid->name, solid->solid.edited(std::move(edit))));
}

Changes transform(const Lsu& solids, std::string_view name, Step step) {
  return edit(solids, name, {0, step});
}

Changes combine(const Lsu& solids, const std::string& name, std::string_view left,
                Operation operation, std::string_view right, bool apart) {
  require_free(solids, name);
  const EntryPtr left_solid = require(solids, left), right_solid = require(solids, right);
  if (left_solid == right_solid)
    throw CommandError("a solid cannot be combined with itself; copy " + in_quotes(left) +
                       " first");
  const NodePtr &left_tree = left_solid->solid.tree(), &right_tree = right_solid->solid.tree();
  // Nodes are shared until they are written or traced: sixty combinations of a solid with its copy
  // would be 2^60 of them.
  if (const std::size_t nodes = 1 + left_tree->count + right_tree->count; nodes > limits().nodes)
    throw CommandError(in_quotes(name) + " would have " + std::to_string(nodes) + " nodes; " +
                       at_most(limits().nodes, "nodes", "--max-nodes"));
  if (!apart) require_meeting(operation, left, left_tree->bounds, right, right_tree->bounds);
  Changes changes =
      added(solids, entry(name, make_node(name, Composite{operation, left_tree, right_tree})));
  changes.push_back({solids.place_of(left), left_solid, nullptr});
  changes.push_back({solids.place_of(right), right_solid, nullptr});
  return changes;
}

Changes erase(const Lsu& solids, std::string_view name) {
  const EntryPtr solid = require(solids, name);
  return replaced(solids, solid, nullptr);
}

Changes copy(const Lsu& solids, std::string_view source, const std::string& destination) {
  const EntryPtr solid = require(solids, source);
  require_free(solids, destination);
  return added(solids, entry(destination, renamed(*solid->solid.tree(), destination)));
}

Changes split(const Lsu& solids, std::string_view name) {
  const EntryPtr solid = require(solids, name);
  const NodePtr& tree = solid->solid.tree();
  const Composite* composite = tree->composite();
  if (composite == nullptr) throw CommandError(in_quotes(name) + " is not a composite");
  // Its own name is free: the solid goes.
  const auto free = [&](const std::string& wanted, std::string_view besides) {
    return wanted == solid->name && wanted != besides ? wanted : free_name(solids, wanted, besides);
  };
  const std::string left = free(composite->left->name, {});
  const std::string right = free(composite->right->name, left);
  Changes changes = replaced(solids, solid, nullptr);
  changes.push_back({solids.free_place(), nullptr, entry(left, composite->left)});
  changes.push_back({solids.free_place(1), nullptr, entry(right, composite->right)});
  return changes;
}

Changes insert(const Lsu& solids, const std::string& name, const NodePtr& tree) {
  require_free(solids, name);
  return added(solids, entry(name, tree->name == name ? tree : renamed(*tree, name)));
}

Changes rename(const Lsu& solids, std::string_view name, const std::string& new_name) {
  const EntryPtr solid = require(solids, name);
  require_free(solids, new_name);
  return replaced(solids, solid, entry(new_name, renamed(*solid->solid.tree(), new_name)));
}

Changes label(const Lsu& solids, std::string_view name, const std::string& label) {
  return edit(solids, name, {0, Label{label}, false});
}

Changes number(const Lsu& solids, std::string_view name, FileSlot slot) {
  const EntryPtr solid = require(solids, name);
  return replaced(solids, solid, entry(solid->name, renumbered(*solid->solid.tree(), slot)));
}

}  // namespace sir::modeler
