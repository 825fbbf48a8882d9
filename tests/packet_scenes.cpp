#include "tests/packet_scenes.h"

#include <cmath>

namespace sir::test {

Scene union_of_parts(std::uint64_t seed, int parts, double size, bool aligned) {
  SceneBuilder build;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(-2, 2);
  const auto primitive = [&](glm::dvec3 about) {
    const auto kind = static_cast<PrimitiveKind>(random() % 4);
    if (!aligned) {
      Placement placement = random_placement(random, size, random() % 2);
      placement.translation = about;
      return build.primitive(kind, placement);
    }
    const auto edge = [&] { return 0.5 * static_cast<double>(1 + random() % 2); };
    return build.primitive(
        kind, placed(glm::dvec3(edge(), edge(), edge()), glm::round(about * 2.0) / 2.0));
  };
  const auto point = [&] { return glm::dvec3(any(random), any(random), any(random)); };
  SceneBuilder::Id root = 0;
  for (int n = 0; n < parts; ++n) {
    const glm::dvec3 centre = point();
    auto part = primitive(centre);
    for (std::uint64_t k = random() % 3; k > 0; --k)
      part = build.combine(random() % 3 ? Operation::difference : Operation::intersection, part,
                           primitive(centre + point() * (size / 2)));
    root = n == 0 ? part : build.combine(Operation::union_of, root, part);
  }
  return build.finish(root);
}

}  // namespace sir::test
