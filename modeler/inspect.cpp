#include "modeler/inspect.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "modeler/coincidence.h"
#include "modeler/operations.h"
#include "modeler/sampling.h"
#include "modeler/step.h"
#include "modeler/view.h"
#include "tracer/names.h"
#include "tracer/text_file.h"

namespace sir::modeler {
namespace {

constexpr std::size_t kShort = 12;               // primitives, coincidences where all is told
constexpr std::size_t kShortTree = 60;           // nodes there
constexpr std::size_t kRays = 12 * 1024;         // for the volume
constexpr std::size_t kMostTests = 100'000'000;  // primitives times rays, or fewer rays do
constexpr double kNearlySingular = 1e8;

std::string text_of(const glm::dvec3& v) {
  return fmt::format("{:.9g} {:.9g} {:.9g}", v.x, v.y, v.z);
}

std::string text_of(const Box& box) {
  if (is_empty(box)) return "empty";
  return text_of(box.low) + " to " + text_of(box.high);
}

std::string surfaces_text(const Primitive& primitive) {
  if (!primitive.surface_per_face) return fmt::format("surface {}", primitive.surfaces[0]);
  std::string text = "surfaces";
  for (int face = 0; face < face_count(primitive.kind); ++face)
    text += fmt::format("{} {} {}", face > 0 ? "," : "", face_name(primitive.kind, face),
                        primitive.surfaces[static_cast<std::size_t>(face)]);
  return text;
}

// Four lines of four, as in the .CSG; columns line up.
std::string matrix_text(const Placement& placement) {
  std::string cells[4][4];
  std::size_t width[4] = {};
  for (int line = 0; line < 4; ++line) {
    const glm::dvec3& v = line < 3 ? placement.linear[line] : placement.translation;
    for (int column = 0; column < 4; ++column) {
      cells[line][column] =
          column == 3 ? (line == 3 ? "1" : "0") : fmt::format("{:.9g}", v[column]);
      width[column] = std::max(width[column], cells[line][column].size());
    }
  }
  std::string text;
  for (const auto& line : cells)
    text += fmt::format("    {:>{}}  {:>{}}  {:>{}}  {}\n", line[0], width[0], line[1], width[1],
                        line[2], width[2], line[3]);
  return text;
}

double condition(const glm::dmat3& m) {
  const glm::dmat3 inverse = inverse_of({m, glm::dvec3(0.0)}).linear;
  double size = 0, back = 0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) {
      size = std::hypot(size, m[column][row]);
      back = std::hypot(back, inverse[column][row]);
    }
  return size * back / 3;  // 1 for the identity
}

std::string matrices_text(const Node& tree, std::size_t most) {
  std::string text;
  std::size_t shown = 0, left_out = 0;
  for (const Node* node : preorder(tree)) {
    const Primitive* primitive = node->primitive();
    if (primitive == nullptr) continue;
    if (shown == most) {
      ++left_out;
      continue;
    }
    ++shown;
    const std::string of = tree.composite() != nullptr ? " of " + in_quotes(node->name) : "";
    text +=
        fmt::format("  LOCAL_CENA{}\n{}  CENA_LOCAL{}\n{}", of, matrix_text(primitive->local_cena),
                    of, matrix_text(inverse_of(primitive->local_cena)));
  }
  if (left_out > 0) text += fmt::format("  and of {} more\n", counted(left_out, "primitive"));
  return text;
}

std::string surface_list(const Node& tree) {
  if (const Primitive* primitive = tree.primitive()) return "  " + surfaces_text(*primitive) + "\n";
  std::set<std::int64_t> numbers;
  for (const Node* node : preorder(tree))
    if (const Primitive* primitive = node->primitive())
      numbers.insert(primitive->surfaces.begin(),
                     primitive->surfaces.begin() + face_count(primitive->kind));
  return fmt::format("  surface{} {}\n", numbers.size() == 1 ? "" : "s", fmt::join(numbers, ", "));
}

std::string volume_text(const Node& tree, const std::stop_token& stop) {
  const Sampling sampling =
      sample(tree, std::clamp(kMostTests / tree.count, kRays / 16, kRays), stop);
  if (!sampling.inside)
    return sampling.rays == 0 ? "  volume 0: the bounds are empty\n"
                              : fmt::format("  volume 0: none of {} rays met it\n", sampling.rays);
  if (!std::isnormal(sampling.volume) || !std::isfinite(sampling.error))
    return fmt::format("  volume too {} for a number\n", sampling.volume < 1 ? "small" : "large");
  // As many digits as the error leaves.
  const double error = std::max(sampling.error, 1e-6 * sampling.volume);
  const int digits = std::clamp(
      1 + static_cast<int>(std::floor(std::log10(sampling.volume)) - std::floor(std::log10(error))),
      2, 7);
  return fmt::format("  volume {:.{}g}, give or take {:.1g} ({} rays)\n", sampling.volume, digits,
                     error, sampling.rays);
}

std::string text_of_empty(const Node& node) {
  const Composite& composite = *node.composite();
  const std::string of = in_quotes(node.name), left = in_quotes(composite.left->name),
                    right = in_quotes(composite.right->name);
  if (composite.operation == Operation::difference)
    return fmt::format("{} is empty: {} takes away all of {}", of, right, left);
  return fmt::format(
      "{} is empty: {} and {} share nothing{}", of, left, right,
      meet(composite.left->bounds, composite.right->bounds) ? ", though their bounds meet" : "");
}

// As show frames it.
Box box_in_obs(const Node& tree, const std::stop_token& stop) {
  const Box& box = tree.bounds;
  if (!can_be_framed(box)) return {};
  return bounds_in_obs(tree, framing(filled_box(tree, stop), 4.0 / 3)).front();
}

}  // namespace

std::string type_text(const Node& node) {
  if (const Primitive* primitive = node.primitive()) return std::string(name_of(primitive->kind));
  const Composite& composite = *node.composite();
  return fmt::format("{} of {} and {}, {}", name_of(composite.operation),
                     in_quotes(composite.left->name), in_quotes(composite.right->name),
                     counted(node.count, "node"));
}

std::string tree_text(const Node& tree, std::size_t most) {
  constexpr std::size_t kMostLevels = 40;
  struct Open {
    const Node* node;
    std::size_t level;
    bool last;
  };
  std::string text;
  std::vector<Open> open{{&tree, 0, true}};
  std::vector<char> goes_on;  // by level: more of that parent is to come
  std::size_t shown = 0;      // and so the place of the next node
  const std::size_t digits = std::to_string(std::min(most, tree.count) - 1).size();
  while (!open.empty() && shown < most) {
    const auto [node, level, last] = open.back();
    open.pop_back();
    text += fmt::format("  {:>{}} ", shown, digits);
    for (std::size_t i = 1; i < level; ++i) text += goes_on[i] != 0 ? "│ " : "  ";
    if (level > 0) text += last ? "└ " : "├ ";
    goes_on.resize(std::max(goes_on.size(), level + 1));
    goes_on[level] = !last;
    ++shown;
    const Composite* composite = node->composite();
    if (composite == nullptr) {
      const Primitive& primitive = *node->primitive();
      text += fmt::format("{}: {}, {}\n", visible(node->name), name_of(primitive.kind),
                          surfaces_text(primitive));
      continue;
    }
    text += fmt::format("{}: {}", visible(node->name), name_of(composite->operation));
    if (level == kMostLevels) {
      text += fmt::format(", and {} below\n", counted(node->count - 1, "node"));
      shown += node->count - 1;
      continue;
    }
    text += "\n";
    open.push_back({composite->right.get(), level + 1, true});
    open.push_back({composite->left.get(), level + 1, false});
  }
  if (shown < tree.count)
    text += fmt::format("  and {} more\n", counted(tree.count - shown, "node"));
  return text;
}

std::optional<std::string> empty_warning(const Node& node) {
  if (leaves_nothing(node)) return text_of_empty(node);
  return std::nullopt;
}

std::vector<std::string> warnings(const Node& tree, std::size_t most_coincidences,
                                  std::stop_token stop) {
  std::vector<std::string> found;
  for (const Node* node : empty_composites(tree, stop)) found.push_back(text_of_empty(*node));
  if (stop.stop_requested()) return found;
  const auto pairs = coincident_faces(tree, most_coincidences + 1);
  const auto face = [](const Face& of) {
    return fmt::format("{} of {}", face_name(of.node->primitive()->kind, of.face),
                       in_quotes(of.node->name));
  };
  for (std::size_t i = 0; i < std::min(pairs.size(), most_coincidences); ++i)
    found.push_back(
        fmt::format("faces coincide: {} and {}", face(pairs[i].first), face(pairs[i].second)));
  if (pairs.size() > most_coincidences) found.push_back("and more faces coincide");
  for (const Node* node : preorder(tree)) {
    const Primitive* primitive = node->primitive();
    if (primitive == nullptr) continue;
    const double worst = condition(primitive->local_cena.linear);
    if (worst > kNearlySingular)
      found.push_back(fmt::format("the matrix of {} is nearly singular: condition {:.2g}",
                                  in_quotes(node->name), worst));
  }
  return found;
}

std::string inspect(const std::string& name, const Node& tree, Aspect aspect,
                    std::stop_token stop) {
  const bool all = aspect == Aspect::all;
  const auto wanted = [&](Aspect one) { return all || aspect == one; };
  std::string text = fmt::format("{}: {}\n", in_quotes(name), type_text(tree));
  if (tree.name != name) text += fmt::format("  in the .CSG {}\n", in_quotes(tree.name));
  if (tree.slot.number != FileSlot::kNone) text += fmt::format("  number {}\n", tree.slot.number);
  if (wanted(Aspect::bounds))
    text += fmt::format("  bounds in SC_CENA {}\n  bounds in SC_OBS  {}\n", text_of(tree.bounds),
                        text_of(box_in_obs(tree, stop)));
  if (wanted(Aspect::matrices)) text += matrices_text(tree, all ? kShort : tree.count);
  if (wanted(Aspect::surfaces)) text += surface_list(tree);
  if (wanted(Aspect::tree) && (tree.composite() != nullptr || !all))
    text += tree_text(tree, all ? kShortTree : tree.count);
  if (wanted(Aspect::volume)) text += volume_text(tree, stop);
  if (wanted(Aspect::warnings)) {
    const auto lines = warnings(tree, all ? kShort : 1000, stop);
    for (const std::string& line : lines) text += "  warning: " + line + "\n";
    if (lines.empty()) text += "  no warnings\n";
  }
  return text;
}

}  // namespace sir::modeler
