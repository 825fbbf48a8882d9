#include "modeler/script_text.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <fmt/format.h>

#include "modeler/command_line.h"
#include "modeler/csg.h"
#include "modeler/operations.h"
#include "modeler/step.h"
#include "tracer/names.h"
#include "tracer/text_file.h"

namespace sir::modeler {
namespace {

bool same_bits(const glm::dvec3& a, const glm::dvec3& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::bit_cast<std::uint64_t>(a[axis]) != std::bit_cast<std::uint64_t>(b[axis]))
      return false;
  return true;
}

bool same_bits(const Placement& a, const Placement& b) {
  for (int line = 0; line < 3; ++line)
    if (!same_bits(a.linear[line], b.linear[line])) return false;
  return same_bits(a.translation, b.translation);
}

std::string text_of(const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

// A turn by quarters about an axis; 0 degrees: none.
struct Turn {
  int axis = 0;
  int degrees = 0;
};
constexpr Turn kTurns[] = {{0, 0},   {0, 90},  {1, 90},  {2, 90},  {0, -90},
                           {1, -90}, {2, -90}, {0, 180}, {1, 180}, {2, 180}};

// Scale, turn and translation; none where these do not give the bits, or only with a mirror that is
// not wanted.
std::optional<std::string> in_steps(const Placement& wanted, const std::string& name,
                                    const Turn& turn, bool mirrored) {
  const Step rotation = rotation_about(turn.axis, turn.degrees);
  // What the scale must have been for the turn to give these lines.
  glm::dvec3 factors;
  for (int line = 0; line < 3; ++line)
    factors[line] = glm::dot(rotation.linear[line], wanted.linear[line]);
  for (int axis = 0; axis < 3; ++axis)
    if (factors[axis] == 0 || (factors[axis] < 0 && !mirrored)) return std::nullopt;
  Placement placement;
  std::string text;
  if (factors != glm::dvec3(1.0)) {
    placement = appended(placement, scale_by(factors));
    const bool even = factors.x == factors.y && factors.y == factors.z;
    text +=
        fmt::format("scale {} {}\n", name, even ? fmt::format("{}", factors.x) : text_of(factors));
  }
  if (turn.degrees != 0) {
    placement = appended(placement, rotation);
    text += fmt::format("rotate {} {} {}\n", name, "xyz"[turn.axis], turn.degrees);
  }
  if (wanted.translation != glm::dvec3(0.0)) {
    placement = appended(placement, translation_by(wanted.translation));
    text += fmt::format("translate {} {}\n", name, text_of(wanted.translation));
  }
  return same_bits(placement, wanted) ? std::optional(text) : std::nullopt;
}

std::string placement_text(const Placement& placement, const std::string& name) {
  for (const bool mirrored : {false, true})
    for (const Turn& turn : kTurns)
      if (auto text = in_steps(placement, name, turn, mirrored)) return *text;
  std::string text = "matrix " + name;
  for (int line = 0; line < 4; ++line)
    text += " " + text_of(line < 3 ? placement.linear[line] : placement.translation);
  return text + "\n";
}

// Names that are free in the list as the script goes on.
class Names {
 public:
  std::string take(const std::string& wanted) {
    std::string name = wanted;
    for (int& i = next_.try_emplace(wanted, 2).first->second; taken_.contains(name); ++i)
      name = fmt::format("{} ({})", wanted, i);
    taken_.insert(name);
    return name;
  }
  void give_back(const std::string& name) { taken_.erase(name); }

 private:
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, int> next_;  // to be tried for a name
};

}  // namespace

std::string script_text(const Node& tree, const std::string& save_as) {
  const std::vector<const Node*> nodes = preorder(tree);
  std::string text = fmt::format("# {}, {}; sir model makes it from this script.\n", save_as,
                                 counted(tree.count, "node"));
  // The order of the commands is postorder, left before right, so that a part stands next to what
  // it becomes part of.
  struct Open {
    const Node* node;
    bool parts_done;
  };
  std::vector<Open> open{{&tree, false}};
  std::vector<std::string> made;  // names in the list, of the parts whose whole is not yet there
  Names names;
  bool after_combine = true;
  while (!open.empty()) {
    const auto [node, parts_done] = open.back();
    open.pop_back();
    const Composite* composite = node->composite();
    if (composite != nullptr && !parts_done) {
      open.push_back({node, true});
      open.push_back({composite->right.get(), false});
      open.push_back({composite->left.get(), false});
      continue;
    }
    std::string name;
    if (composite == nullptr) {
      if (after_combine) text += "\n";
      name = names.take(visible(node->name));
      const Primitive& primitive = *node->primitive();
      text += fmt::format("create {} {}", as_word(name), name_of(primitive.kind));
      const int numbers = primitive.surface_per_face ? face_count(primitive.kind) : 1;
      for (int face = 0; face < numbers; ++face)
        text += fmt::format(" {}", primitive.surfaces[static_cast<std::size_t>(face)]);
      text += "\n" + placement_text(primitive.local_cena, as_word(name));
    } else {
      const std::string right = std::move(made.back());
      made.pop_back();
      const std::string left = std::move(made.back());
      made.pop_back();
      name = names.take(visible(node->name));
      const bool apart = composite->operation != Operation::union_of &&
                         !meet(composite->left->bounds, composite->right->bounds);
      text += fmt::format("combine {} {} {} {}{}\n", as_word(name), as_word(left),
                          name_of(composite->operation), as_word(right), apart ? " apart" : "");
      names.give_back(left);
      names.give_back(right);
    }
    after_combine = composite != nullptr;
    if (name != node->name)
      text += fmt::format("label {} {}\n", as_word(name), as_word(node->name));
    if (node->slot.number != FileSlot::kNone) {
      text += fmt::format("number {} {}", as_word(name), node->slot.number);
      if (node->slot.position != FileSlot::kNone) text += fmt::format(" {}", node->slot.position);
      text += "\n";
    }
    made.push_back(std::move(name));
  }
  return text + fmt::format("\nsave {} {}\n", as_word(made.back()), as_word(save_as));
}

}  // namespace sir::modeler
