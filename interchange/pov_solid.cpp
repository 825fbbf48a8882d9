#include "interchange/pov_solid.h"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>

#include "interchange/pov_surface.h"
#include "tracer/text_file.h"

namespace sir {
namespace {

// What transparent surfaces below a node say of the medium inside.
struct Medium {
  double index = 0;  // 0: all is opaque
  bool mixed = false;
  void add(const Medium& other) {
    mixed = mixed || other.mixed || (index > 0 && other.index > 0 && index != other.index);
    if (index == 0) index = other.index;
  }
};

// A node of the composition with chains flattened; a difference has its minuend
// first. Parents stand before their children.
struct Part {
  const CsgNode* node;  // of a chain, the first met
  std::vector<std::size_t> members;
  Medium medium;
};

class Writer {
 public:
  Writer(const Scene& scene, const PovFrame& frame) : scene_(scene), frame_(frame) {
    for (const Surface& surface : scene.surfaces) surfaces_.emplace(surface.number, &surface);
    flatten();
    for (std::size_t p = parts_.size(); p-- > 0;) {
      if (!parts_[p].node->composite) parts_[p].medium = medium_of(*parts_[p].node);
      for (const std::size_t member : parts_[p].members)
        parts_[p].medium.add(parts_[member].medium);
    }
  }

  PovSolid solid() const;

 private:
  // What is still to be written, last first.
  struct Task {
    std::size_t part = 0;
    int indent = 0;
    bool medium_known = false;
    std::string words;  // instead of a part
  };

  void flatten();
  std::vector<const Surface*> surfaces_of(const CsgNode& primitive) const;
  Medium medium_of(const CsgNode& primitive) const;
  std::string primitive(const CsgNode& node) const;
  void expand(const Task& task, std::vector<Task>& tasks) const;

  const Scene& scene_;
  const PovFrame& frame_;
  std::unordered_map<std::int64_t, const Surface*> surfaces_;
  std::vector<Part> parts_;
};

void Writer::flatten() {
  enum class Role { whole, member, minuend, subtrahend };
  struct Open {
    std::size_t node, parent;
    Role role;
  };
  std::vector<Open> open{{scene_.tree.root, 0, Role::whole}};
  while (!open.empty()) {
    const Open item = open.back();
    open.pop_back();
    const CsgNode& node = scene_.tree.nodes[item.node];
    std::size_t home = item.parent;
    Role left = Role::member, right = Role::member;
    bool joins = false;
    if (item.role != Role::whole && node.composite) {
      const bool like = parts_[home].node->operation == node.operation;
      joins = item.role == Role::member    ? like
              : item.role == Role::minuend ? like  // (A - B) - C = A - B - C
                                           : node.operation == Operation::union_of;
      if (joins && item.role == Role::subtrahend) left = right = Role::subtrahend;
    }
    if (node.composite && node.operation == Operation::difference) {
      left = Role::minuend;
      right = Role::subtrahend;
    }
    if (!joins) {
      if (item.role != Role::whole) parts_[home].members.push_back(parts_.size());
      home = parts_.size();
      parts_.push_back({&node, {}, {}});
    }
    if (!node.composite) continue;
    open.push_back({node.right, home, right});
    open.push_back({node.left, home, left});
  }
}

std::vector<const Surface*> Writer::surfaces_of(const CsgNode& primitive) const {
  std::vector<const Surface*> found;
  for (std::size_t face = 0; face < static_cast<std::size_t>(face_count(primitive.kind)); ++face)
    found.push_back(surfaces_.at(primitive.surfaces[face]));
  return found;
}

Medium Writer::medium_of(const CsgNode& primitive) const {
  Medium medium;
  for (const Surface* surface : surfaces_of(primitive)) {
    if (surface->first.transmission > 0) medium.add({surface->first.index, false});
    if (surface->texture == TextureKind::chequer && surface->second.transmission > 0)
      medium.add({surface->second.index, false});
  }
  return medium;
}

std::string Writer::primitive(const CsgNode& node) const {
  constexpr const char* kShape[] = {"box { <0,0,0>, <1,1,1>", "sphere { <0,0,0>, 1",
                                    "cone { <0,0,0>, 1, <0,1,0>, 0",
                                    "cylinder { <0,0,0>, <0,1,0>, 1"};
  std::string text = fmt::format("{} {} matrix <", kShape[static_cast<int>(node.kind)],
                                 pov_texture_of(node, surfaces_of(node)));
  // POV-Ray's matrices are for row vectors as LOCAL_CENA is.
  for (int line = 0; line < 3; ++line)
    for (int i = 0; i < 3; ++i)
      text += fmt::format("{:.17g},", frame_.factor * node.placement.linear[line][i]);
  const glm::dvec3 origin = frame_.apply(node.placement.translation);
  return text + fmt::format("{:.17g},{:.17g},{:.17g}>", origin.x, origin.y, origin.z);
}

std::string interior(double index) {
  // A ray that is not bent at all would not count for max_trace_level: the next
  // float after 1 bends it by a ten-millionth.
  if (index == 1) index = 1.00000012;
  return fmt::format("interior {{ ior {:.9g} }}", index);
}

// Replaces a part by what it is made of.
void Writer::expand(const Task& task, std::vector<Task>& tasks) const {
  const Part& part = parts_[task.part];
  const CsgNode& node = *part.node;
  const std::string margin(static_cast<std::size_t>(2 * std::min(task.indent, 20)), ' ');
  const bool transparent = part.medium.index > 0;
  const bool sorted = transparent && part.medium.mixed && !task.medium_known && node.composite &&
                      node.operation == Operation::union_of;
  const bool says_medium = transparent && !task.medium_known && !sorted;
  const auto words = [&](std::string text) { tasks.push_back({0, 0, false, std::move(text)}); };

  std::string end = says_medium ? " " + interior(part.medium.index) : "";
  if (says_medium && part.medium.mixed) end += " // further indices in here are not told";
  const std::string label = fmt::format(" // {} {}\n", node.number, in_quotes(node.name));
  if (!node.composite) {
    // The brace must not fall into a comment.
    words(margin + primitive(node) +
          (says_medium ? " " + interior(part.medium.index) : std::string()) + " }" + label);
    return;
  }
  const char* operation = node.operation == Operation::difference     ? "difference {"
                          : node.operation == Operation::intersection ? "intersection {"
                          : transparent                               ? "merge {"
                                                                      : "union {";
  words(margin + (end.empty() ? "" : " " + end + "\n" + margin) + "}\n");
  const bool known = task.medium_known || says_medium;
  if (sorted) {
    std::map<double, std::vector<std::size_t>> by_index;
    for (std::size_t m = part.members.size(); m-- > 0;) {
      const std::size_t member = part.members[m];
      const Medium& medium = parts_[member].medium;
      if (medium.index == 0 || medium.mixed) tasks.push_back({member, task.indent + 1, false, {}});
      else by_index[medium.index].push_back(member);
    }
    for (const auto& [index, members] : by_index) {
      if (members.size() == 1) {
        tasks.push_back({members[0], task.indent + 1, false, {}});
        continue;
      }
      words(margin + "  " + interior(index) + " }\n");
      for (const std::size_t member : members) tasks.push_back({member, task.indent + 2, true, {}});
      words(margin + "  merge {\n");
    }
  } else {
    for (std::size_t m = part.members.size(); m-- > 0;)
      tasks.push_back({part.members[m], task.indent + 1, known, {}});
  }
  words(margin + operation + label);
}

PovSolid Writer::solid() const {
  PovSolid solid;
  const Medium& whole = parts_[0].medium;
  const bool one_medium = whole.index > 0 && !whole.mixed;
  if (one_medium) solid.interior = interior(whole.index);
  std::vector<Task> tasks{{0, 0, one_medium, {}}};
  while (!tasks.empty()) {
    const Task task = std::move(tasks.back());
    tasks.pop_back();
    if (task.words.empty()) expand(task, tasks);
    else solid.text += task.words;
  }
  return solid;
}

}  // namespace

PovSolid pov_solid(const Scene& scene, const PovFrame& frame) {
  return Writer(scene, frame).solid();
}

}  // namespace sir
