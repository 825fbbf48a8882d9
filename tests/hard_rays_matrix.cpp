// Hard matrices: anisotropy, shears, high condition numbers, mirrors.
#include "tests/hard_rays_dice.h"

namespace sir::test {
namespace {

PrimitiveKind kind_of(int n) { return kKinds[static_cast<std::size_t>(n % 4)]; }

// A ray through the inside of a primitive: along a direction of SC_LOCAL (which
// crosses it however it is stretched), or along any direction of SC_CENA.
HardRay aimed(Dice& dice, PrimitiveKind kind, const Placement& placement, bool local) {
  const Shared scene = alone(kind, placement);
  const glm::dvec3 point = inner_point(dice, kind);
  const double back = dice.real(0.5, 8);
  if (local) return through({scene, placement, point, dice.reals(-1, 1), back});
  // From about a size away.
  double size = 0;
  for (int i = 0; i < 3; ++i) size = std::max(size, glm::length(placement.linear[i]));
  return through({scene, to_scene(placement, point), size * dice.reals(-1, 1), back});
}

glm::dmat3 diagonal(const glm::dvec3& d) {
  return glm::dmat3({d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z});
}

glm::dvec3 unequal(Dice& dice, int most) {
  glm::dvec3 scale;
  for (int i = 0; i < 3; ++i) {
    scale[i] = ten(dice.between(-most, most));
    if (dice.coin()) scale[i] *= dice.real(1, 5);
  }
  return scale;
}

std::vector<HardRay> aniso(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 120; ++n) {
    const glm::dvec3 scale = unequal(dice, 6);
    const Placement placement = placed(scale, dice.reals(-2, 2));
    rays.push_back(aimed(dice, kind_of(n), placement, n % 8 < 4));
  }
  return rays;
}

// Scaled then turned; or turned, scaled and turned back.
std::vector<HardRay> aniso_rotated(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 120; ++n) {
    const glm::dmat3 turn = rotation(dice);
    Placement placement;
    placement.linear = turn * diagonal(unequal(dice, 6));
    if (n % 2) placement.linear = placement.linear * glm::transpose(turn);
    placement.translation = dice.reals(-2, 2);
    rays.push_back(aimed(dice, kind_of(n / 2), placement, n % 3 != 0));
  }
  return rays;
}

std::vector<HardRay> shear(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 120; ++n) {
    Placement placement = n % 2 ? general_placement(dice) : aligned_placement(dice);
    const int from = dice.below(3), to = (from + dice.between(1, 2)) % 3;
    double amount = ten(dice.between(-1, 5));
    amount *= dice.sign();
    amount *= dice.between(1, 9);
    placement.linear[from] += amount * placement.linear[to];
    rays.push_back(aimed(dice, kind_of(n / 2), placement, n % 3 != 0));
  }
  return rays;
}

// Singular values 1, 1 (or between) and 10^-k, between two rotations.
std::vector<HardRay> with_condition(Dice& dice, int low, int high, int count) {
  std::vector<HardRay> rays;
  for (int n = 0; n < count; ++n) {
    const int k = low + n % (high - low + 1);
    Placement placement;
    const double middle = dice.coin() ? 1 : ten(-dice.between(0, k));
    const glm::dmat3 first = rotation(dice);
    placement.linear = rotation(dice) * diagonal({1, middle, ten(-k)}) * first;
    placement.translation = dice.reals(-2, 2);
    rays.push_back(aimed(dice, kind_of(n), placement, n % 3 != 0));
  }
  return rays;
}
std::vector<HardRay> condition(Dice& dice) { return with_condition(dice, 2, 12, 132); }
std::vector<HardRay> near_singular(Dice& dice) {
  std::vector<HardRay> rays = with_condition(dice, 14, 16, 72);
  // A determinant of one unit in the last place, by construction.
  for (int n = 0; n < 24; ++n) {
    Placement placement = short_placement(dice);
    placement.linear[2] = placement.linear[0] + placement.linear[1];
    placement.linear[2][n % 3] += 0x1p-48 * dice.between(1, 3);
    if (glm::determinant(placement.linear) == 0) continue;
    rays.push_back(aimed(dice, kind_of(n), placement, n % 2 == 0));
  }
  return rays;
}

// Mirrored solids, cut out of one another.
std::vector<HardRay> mirrored(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 120; ++n) {
    const auto make = [&] {
      Placement placement = n % 2 ? general_placement(dice) : short_placement(dice);
      if (glm::determinant(placement.linear) > 0) placement.linear[dice.below(3)] *= -1.0;
      return placement;
    };
    const Part left{kind_of(n), make()};
    Part right{kKinds[static_cast<std::size_t>(dice.below(4))], make()};
    right.placement.translation = left.placement.translation;
    const Shared scene = pair_of(dice, kOperations[static_cast<std::size_t>(n % 3)], left, right);
    const glm::dvec3 point = inner_point(dice, left.kind);
    rays.push_back(through({scene, left.placement, point,
                            n % 5 ? dice.reals(-1, 1) : dice.integers(2), dice.real(-0.2, 5)}));
  }
  return rays;
}

}  // namespace

std::vector<HardClass> hard_classes_matrix() {
  return {{"aniso", aniso},         {"aniso_rotated", aniso_rotated}, {"shear", shear},
          {"condition", condition}, {"near_singular", near_singular}, {"mirrored", mirrored}};
}

}  // namespace sir::test
