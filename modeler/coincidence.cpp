#include "modeler/coincidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "modeler/step.h"

namespace sir::modeler {
namespace {

constexpr double kSame = 1e-12;
constexpr std::size_t kMostPairs = 2'000'000;  // compared

using Row = std::array<double, 4>;            // of an affine map: x, y, z, 1
using Coefficients = std::array<double, 10>;  // of a quadric, of length 1; a plane has four

struct Sheet {
  Face face;
  std::size_t index;  // of the node
  Coefficients form{};
  Box box;  // of the face
  bool flat = false;
  double key = 0;  // equal forms have equal ones
};

// Coordinates in which the solid is about the unit box.
struct Units {
  glm::dvec3 centre{0.0};
  double size = 1;
};

// Sums of sign * row * row for the quadric; the last row stands for 1.
void add_square(Coefficients& form, const Row& row, double sign) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i; j < 4; ++j) form[at++] += sign * (i == j ? 1 : 2) * row[i] * row[j];
}

void settle(Sheet& sheet) {
  double square = 0, largest = 0;
  for (const double c : sheet.form) {
    square += c * c;
    largest = std::max(largest, std::abs(c));
  }
  // Both signs mean the same: the first coefficient that is large is positive.
  const auto large = std::find_if(sheet.form.begin(), sheet.form.end(),
                                  [&](double c) { return std::abs(c) > 0.9 * largest; });
  const double factor = (*large < 0 ? -1 : 1) / std::sqrt(square);
  double weight = 1;
  for (double& c : sheet.form) {
    c *= factor;
    sheet.key += weight * c;
    weight *= 0.618033988749895;
  }
}

// The box of a cube's face or of a cap, as that of a flat primitive.
Box flat_box(const Primitive& primitive, int face) {
  LocalCena<double> way;
  way.linear = primitive.local_cena.linear;
  way.translation = primitive.local_cena.translation;
  const auto flatten = [&](int axis, bool far) {
    if (far) way.translation += way.linear[axis];
    way.linear[axis] = glm::dvec3(0.0);
  };
  if (primitive.kind == PrimitiveKind::cube) {
    flatten(face / 2, face % 2 == 1);
    return tight_bounds_of(PrimitiveKind::cube, way);
  }
  flatten(1, primitive.kind == PrimitiveKind::cylinder && face == 1);
  return tight_bounds_of(PrimitiveKind::cylinder, way);
}

void add_sheets(const Node& node, std::size_t index, const Units& units,
                std::vector<Sheet>& sheets) {
  const Primitive& primitive = *node.primitive();
  const Placement back = inverse_of(primitive.local_cena);
  const glm::dvec3 origin = back.linear * (units.centre - primitive.local_cena.translation);
  std::array<Row, 3> local;  // SC_LOCAL's coordinates as forms
  for (int axis = 0; axis < 3; ++axis)
    local[static_cast<std::size_t>(axis)] = {units.size * back.linear[0][axis],
                                             units.size * back.linear[1][axis],
                                             units.size * back.linear[2][axis], origin[axis]};
  constexpr Row kOne{0, 0, 0, 1};
  for (int face = 0; face < face_count(primitive.kind); ++face) {
    Sheet sheet;
    sheet.face = {&node, face};
    sheet.index = index;
    const auto plane = [&](std::size_t axis, double at) {
      sheet.flat = true;
      sheet.box = flat_box(primitive, face);
      std::copy(local[axis].begin(), local[axis].end(), sheet.form.begin());
      sheet.form[3] -= at;
    };
    const auto round = [&](double y, double one) {
      sheet.box = node.bounds;
      add_square(sheet.form, local[0], 1);
      add_square(sheet.form, local[2], 1);
      if (y != 0) add_square(sheet.form, local[1], y);
      add_square(sheet.form, kOne, one);
    };
    switch (primitive.kind) {
      case PrimitiveKind::cube: plane(static_cast<std::size_t>(face / 2), face % 2); break;
      case PrimitiveKind::sphere: round(1, -1); break;
      case PrimitiveKind::cone:
        if (face == 1) {
          plane(1, 0);
        } else {
          local[1][3] -= 1;
          round(-1, 0);
          local[1][3] += 1;
        }
        break;
      case PrimitiveKind::cylinder:
        if (face < 2) plane(1, face);
        else round(0, -1);
        break;
    }
    settle(sheet);
    sheets.push_back(sheet);
  }
}

bool coincide(const Sheet& a, const Sheet& b, const Units& units) {
  if (a.flat != b.flat || a.index == b.index) return false;
  for (std::size_t i = 0; i < a.form.size(); ++i)
    if (!(std::abs(a.form[i] - b.form[i]) <= kSame)) return false;
  int overlaps = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double shared =
        std::min(a.box.high[axis], b.box.high[axis]) - std::max(a.box.low[axis], b.box.low[axis]);
    if (shared < -1e-9 * units.size) return false;
    if (shared > 1e-9 * units.size) ++overlaps;
  }
  return overlaps >= (a.flat ? 2 : 3);
}

}  // namespace

std::vector<Coincidence> coincident_faces(const Node& tree, std::size_t most) {
  const std::vector<const Node*> nodes = preorder(tree);
  Box all;
  for (const Node* node : nodes)
    if (node->primitive() != nullptr) all.include(node->bounds);
  const glm::dvec3 extent = all.high - all.low;
  const Units units{all.centre(), std::max({extent.x, extent.y, extent.z})};
  if (!std::isfinite(units.size) || !(units.size > 0)) return {};
  std::vector<Sheet> sheets;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i]->primitive() != nullptr) add_sheets(*nodes[i], i, units, sheets);
  std::sort(sheets.begin(), sheets.end(),
            [](const Sheet& a, const Sheet& b) { return a.key < b.key; });
  std::vector<std::pair<const Sheet*, const Sheet*>> pairs;
  std::size_t compared = 0;
  for (std::size_t i = 0; i < sheets.size(); ++i)
    for (std::size_t j = i + 1; j < sheets.size() && compared < kMostPairs; ++j) {
      if (sheets[j].key - sheets[i].key > 3 * kSame) break;
      ++compared;
      if (!coincide(sheets[i], sheets[j], units)) continue;
      const bool in_order = sheets[i].index < sheets[j].index;
      pairs.emplace_back(&sheets[in_order ? i : j], &sheets[in_order ? j : i]);
    }
  std::sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
    return std::tuple(a.first->index, a.second->index, a.first->face.face, a.second->face.face) <
           std::tuple(b.first->index, b.second->index, b.first->face.face, b.second->face.face);
  });
  std::vector<Coincidence> found;
  for (const auto& [first, second] : pairs)
    if (found.size() < most) found.push_back({first->face, second->face});
  return found;
}

}  // namespace sir::modeler
