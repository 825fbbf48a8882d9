// Scenes far from the origin, very small and very large ones, and directions of
// any length.
#include "tests/hard_rays_dice.h"

#include <cmath>

namespace sir::test {
namespace {

// A few solids about the origin, of size 1.
Scene cluster(Dice& dice, bool on_grid) {
  SceneBuilder build;
  auto solid = build.primitive(PrimitiveKind::cube, placed(glm::dvec3(2), glm::dvec3(-1)), 1, 5);
  for (int i = 0; i < 4; ++i) {
    const PrimitiveKind kind = kKinds[static_cast<std::size_t>(dice.below(4))];
    Placement placement = general_placement(dice);
    if (on_grid) {
      glm::dvec3 size, low;
      for (int axis = 0; axis < 3; ++axis) {
        size[axis] = 0.5 * dice.between(1, 3);
        low[axis] = 0.5 * dice.between(-3, 2);
      }
      placement = placed(size, low);
    }
    solid = build.combine(kOperations[static_cast<std::size_t>(i % 2)], solid,
                          build.primitive(kind, placement, 1, (i * 3 + 2) % 5));
  }
  return build.finish(solid);
}

glm::dvec3 near_origin(Dice& dice, bool on_grid) {
  if (!on_grid) return dice.reals(-1, 1);
  return 0.25 * dice.integers(4);
}

std::vector<HardRay> translated(Dice& dice) {
  std::vector<HardRay> rays;
  for (const int k : {2, 3, 6, 8})
    for (int n = 0; n < 32; ++n) {
      const bool on_grid = n % 4 == 3;
      const glm::dvec3 offset = ten(k) * (on_grid ? dice.integers(2) : dice.reals(-1, 1));
      const auto scene = std::make_shared<const Scene>(moved(cluster(dice, on_grid), 1, offset));
      const glm::dvec3 at = near_origin(dice, on_grid) + offset;
      const glm::dvec3 along = on_grid ? dice.integers(2) : dice.reals(-1, 1);
      rays.push_back(through({scene, at, along, double(dice.between(0, 6))}));
    }
  return rays;
}

std::vector<HardRay> scaled(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 80; ++n) {
    const bool on_grid = n % 4 == 3;
    const double factor = std::ldexp(1.0, n % 2 ? 40 : -40);
    const auto scene =
        std::make_shared<const Scene>(moved(cluster(dice, on_grid), factor, {0, 0, 0}));
    const glm::dvec3 at = factor * near_origin(dice, on_grid);
    const glm::dvec3 along = on_grid ? dice.integers(2) : dice.reals(-1, 1);
    rays.push_back(
        {scene, at - factor * dice.between(0, 6) * along, n % 8 < 4 ? along : factor * along});
  }
  return rays;
}

// Directions of length 1e-150 to 1e150.
std::vector<HardRay> direction_length(Dice& dice) {
  std::vector<HardRay> rays;
  for (int k = -150; k <= 150; k += 4) {
    const bool on_grid = k % 12 == 0;
    const auto scene = std::make_shared<const Scene>(cluster(dice, on_grid));
    const glm::dvec3 at = near_origin(dice, on_grid);
    const glm::dvec3 along = on_grid ? dice.integers(2) : dice.reals(-1, 1);
    rays.push_back({scene, at - along * double(dice.between(0, 5)), ten(k) * along});
  }
  return rays;
}

// One component smaller than the others by 10^5 to 10^300: as good as parallel,
// but not parallel.
std::vector<HardRay> direction_uneven(Dice& dice) {
  std::vector<HardRay> rays;
  for (int n = 0; n < 72; ++n) {
    const bool on_grid = n % 3 == 0;
    const auto scene = std::make_shared<const Scene>(cluster(dice, on_grid));
    glm::dvec3 along = on_grid ? dice.integers(2) : dice.reals(-1, 1);
    along[n % 3] = dice.sign() * ten(n < 48 ? -5 * (n / 3 + 1) : -10 * (n - 42));
    const glm::dvec3 at = near_origin(dice, on_grid);
    rays.push_back(through({scene, at, along, double(dice.between(0, 5))}));
  }
  return rays;
}

}  // namespace

std::vector<HardClass> hard_classes_scale() {
  return {{"translated", translated},
          {"scaled", scaled},
          {"direction_length", direction_length},
          {"direction_uneven", direction_uneven}};
}

}  // namespace sir::test
