// The cone's apex, its generators and the nappe that is not there.
#include "tests/hard_rays_dice.h"

namespace sir::test {
namespace {

constexpr PrimitiveKind kCone = PrimitiveKind::cone;
constexpr glm::dvec3 kApex(0, 1, 0);

Placement any_placement(Dice& dice, int variant) {
  if (variant % 3 == 0) return aligned_placement(dice);
  return variant % 3 == 1 ? short_placement(dice) : general_placement(dice);
}

// A direction along a generator: (x, y, z) with x^2 + z^2 = y^2.
glm::dvec3 generator(Dice& dice) {
  const Quadruple q = triple(dice);
  return {q.numerator.x, dice.sign() * q.denominator, q.numerator.z};
}

std::vector<HardRay> apex_through(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 90; ++n) {
    const Placement placement = any_placement(dice, n);
    glm::dvec3 along = dice.integers(4);
    if (n % 2 == 0) along.y = dice.sign() * dice.between(6, 9);  // steep: inside
    rays.push_back(
        through({alone(kCone, placement), placement, kApex, along, double(dice.between(-1, 4))}));
  }
  return rays;
}

// Past the apex by 10^-k, to the side, above or below.
std::vector<HardRay> apex_near(Dice& dice) {
  std::vector<HardRay> rays;
  for (int k = 1; k <= 15; ++k)
    for (int variant = 0; variant < 6; ++variant) {
      const Placement placement = any_placement(dice, variant);
      glm::dvec3 along = dice.integers(4);
      if (variant < 3) along.y = dice.sign() * dice.between(6, 9);
      const glm::dvec3 beside = kApex + ten(-k) * dice.integers(2);
      rays.push_back(
          through({alone(kCone, placement), placement, beside, along, double(dice.between(0, 4))}));
    }
  return rays;
}

std::vector<HardRay> along_generator(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 75; ++n) {
    const Placement placement = any_placement(dice, n);
    rays.push_back(through(
        {alone(kCone, placement), placement, kApex, generator(dice), 0.25 * dice.between(-4, 12)}));
  }
  return rays;
}

std::vector<HardRay> parallel_to_generator(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 75; ++n) {
    const Placement placement = any_placement(dice, n);
    const glm::dvec3 point = n % 2 ? inner_point(dice, kCone) : 0.25 * dice.integers(6);
    rays.push_back(through(
        {alone(kCone, placement), placement, point, generator(dice), 0.25 * dice.between(-2, 12)}));
  }
  return rays;
}

// Off a generator's direction by 10^-k: the far root goes to infinity.
std::vector<HardRay> nearly_generator(Dice& dice) {
  std::vector<HardRay> rays;
  for (int k = 1; k <= 15; ++k)
    for (int variant = 0; variant < 6; ++variant) {
      const Placement placement = any_placement(dice, variant);
      const glm::dvec3 along = generator(dice) + ten(-k) * dice.integers(2);
      const glm::dvec3 point = variant < 3 ? inner_point(dice, kCone) : kApex;
      rays.push_back(
          through({alone(kCone, placement), placement, point, along, 0.25 * dice.between(-2, 12)}));
    }
  return rays;
}

// Rays that cross x^2 + z^2 = (y-1)^2 above the apex, alone or as well.
std::vector<HardRay> upper_nappe(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 90; ++n) {
    const Placement placement = any_placement(dice, n);
    const glm::dvec3 above{0.25 * dice.between(-2, 2), 1 + 0.25 * dice.between(3, 8),
                           0.25 * dice.between(-2, 2)};
    glm::dvec3 along = dice.integers(3);
    if (n % 3 == 0) along.y = 0;
    if (along == glm::dvec3(0)) along.x = 1;
    if (n % 3 == 1) along = inner_point(dice, kCone) - above;  // into the cone itself
    rays.push_back(
        through({alone(kCone, placement), placement, above, along, double(dice.between(-1, 3))}));
  }
  return rays;
}

}  // namespace

std::vector<HardClass> hard_classes_cone() {
  return {{"cone_apex", apex_through},
          {"cone_apex_near", apex_near},
          {"cone_generator", along_generator},
          {"cone_parallel_generator", parallel_to_generator},
          {"cone_nearly_generator", nearly_generator},
          {"cone_upper_nappe", upper_nappe}};
}

}  // namespace sir::test
