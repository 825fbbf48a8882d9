#include "tests/hard_rays_dice.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace sir::test {

glm::dvec3 Dice::reals(double low, double high) {
  const double x = real(low, high), y = real(low, high);
  return {x, y, real(low, high)};
}

glm::dvec3 Dice::integers(int size) {
  glm::dvec3 v(0);
  while (v == glm::dvec3(0))
    for (int i = 0; i < 3; ++i) v[i] = between(-size, size);
  return v;
}

double ten(int k) { return std::strtod(("1e" + std::to_string(k)).c_str(), nullptr); }

Quadruple quadruple(Dice& dice) {
  constexpr int kTable[][4] = {{1, 2, 2, 3},   {2, 3, 6, 7},   {1, 4, 8, 9},
                               {4, 4, 7, 9},   {2, 6, 9, 11},  {6, 6, 7, 11},
                               {3, 4, 12, 13}, {2, 5, 14, 15}, {2, 10, 11, 15}};
  const auto& row = kTable[dice.below(9)];
  const int first = dice.below(3), step = dice.between(1, 2);
  glm::dvec3 v;
  for (int i = 0; i < 3; ++i) v[(first + i * step) % 3] = dice.sign() * row[i];
  return {v, static_cast<double>(row[3])};
}

Quadruple triple(Dice& dice) {
  constexpr int kTable[][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}, {20, 21, 29}};
  const auto& row = kTable[dice.below(5)];
  const bool swapped = dice.coin();
  const double x = dice.sign() * row[swapped ? 1 : 0], z = dice.sign() * row[swapped ? 0 : 1];
  return {{x, 0, z}, static_cast<double>(row[2])};
}

glm::dvec3 across(Dice& dice, const glm::dvec3& normal) {
  while (true) {
    const glm::dvec3 v = glm::cross(normal, dice.integers(3));
    if (v != glm::dvec3(0)) return v;
  }
}

Placement short_placement(Dice& dice, double factor) {
  Placement placement;
  do {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) placement.linear[i][j] = dice.between(-3, 3);
  } while (glm::determinant(placement.linear) == 0);
  placement.linear *= factor;
  for (int i = 0; i < 3; ++i) placement.translation[i] = dice.between(-8, 8);
  return placement;
}

glm::dmat3 rotation(Dice& dice) {
  double a = 0, b = 0, c = 0, d = 0;
  while (a * a + b * b + c * c + d * d == 0) {
    a = dice.between(-9, 9), b = dice.between(-9, 9);
    c = dice.between(-9, 9), d = dice.between(-9, 9);
  }
  const glm::dmat3 whole({a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
                         {2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)},
                         {2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d});
  return whole / (a * a + b * b + c * c + d * d);
}

Placement general_placement(Dice& dice, double size) {
  Placement placement;
  placement.linear = rotation(dice);
  for (int i = 0; i < 3; ++i) placement.linear[i] *= size * dice.real(0.5, 1);
  placement.translation = size * dice.reals(-2, 2);
  return placement;
}

Placement aligned_placement(Dice& dice) {
  glm::dvec3 scale, move;
  for (int i = 0; i < 3; ++i) {
    scale[i] = 0.5 * dice.between(1, 8);
    move[i] = 0.5 * dice.between(-8, 8);
  }
  return placed(scale, move);
}

glm::dvec3 to_scene(const Placement& placement, const glm::dvec3& point) {
  return placement.linear * point + placement.translation;
}

glm::dvec3 inner_point(Dice& dice, PrimitiveKind kind) {
  const auto eighths = [&](int low, int high) { return 0.125 * dice.between(low, high); };
  switch (kind) {
    case PrimitiveKind::cube: return {eighths(1, 7), eighths(1, 7), eighths(1, 7)};
    case PrimitiveKind::sphere: return {eighths(-4, 4), eighths(-4, 4), eighths(-4, 4)};
    case PrimitiveKind::cone: return {eighths(-2, 2), eighths(1, 4), eighths(-2, 2)};
    case PrimitiveKind::cylinder: return {eighths(-4, 4), eighths(1, 7), eighths(-4, 4)};
  }
  return {};
}

Shared alone(PrimitiveKind kind, const Placement& placement) {
  SceneBuilder build;
  return std::make_shared<const Scene>(build.finish(build.primitive(kind, placement)));
}

Shared pair_of(Dice& dice, Operation operation, const Part& left, const Part& right) {
  SceneBuilder build;
  const int first = dice.below(2);
  const auto a = build.primitive(left.kind, left.placement, 1, first);
  const auto b = build.primitive(right.kind, right.placement, 1, 1 - first);
  return std::make_shared<const Scene>(build.finish(build.combine(operation, a, b)));
}

Aim::Aim(Shared scene, const glm::dvec3& point, const glm::dvec3& direction, double back)
    : ray{std::move(scene), point - back * direction, direction} {}

Aim::Aim(Shared scene, const Placement& placement, const glm::dvec3& point,
         const glm::dvec3& direction, double back)
    : Aim(std::move(scene), to_scene(placement, point), placement.linear * direction, back) {}

HardRay through(const Aim& aim) { return aim.ray; }

void append(std::vector<HardClass>& to, const std::vector<HardClass>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

std::uint64_t HardClass::seed() const {
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a
  for (const char letter : name)
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211u;
  return hash;
}

std::vector<HardRay> HardClass::rays() const {
  Dice dice(seed());
  return make(dice);
}

const std::vector<HardClass>& hard_classes() {
  static const std::vector<HardClass> all = [] {
    std::vector<HardClass> classes;
    for (const auto& part : {hard_classes_distance(), hard_classes_grazing(), hard_classes_cone(),
                             hard_classes_flat(), hard_classes_coincident(), hard_classes_start(),
                             hard_classes_matrix(), hard_classes_scale(), hard_classes_tree()})
      append(classes, part);
    return classes;
  }();
  return all;
}

}  // namespace sir::test
