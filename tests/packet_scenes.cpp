#include "tests/packet_scenes.h"

#include <cmath>

#include <hwy/highway.h>

namespace sir::test {

template <typename T>
Products<T> plain_products(const Solid<T>& solid) {
  Products<T> products;
  std::vector<std::vector<std::uint32_t>> positives(solid.products.size());
  auto negatives = positives;
  for (std::uint32_t i = 0; i < solid.leaves.size(); ++i) {
    const Leaf<T>& leaf = solid.leaves[i];
    if (leaf.product < 0) return {};
    (leaf.complemented ? negatives : positives)[static_cast<std::size_t>(leaf.product)].push_back(
        i);
  }
  std::vector<Bounds<T>> boxes;
  for (std::size_t p = 0; p < solid.products.size(); ++p) {
    products.list.push_back({static_cast<std::uint32_t>(products.leaves.size()),
                             static_cast<std::uint32_t>(positives[p].size()),
                             static_cast<std::uint32_t>(negatives[p].size())});
    Bounds<T> box{glm::vec<3, T>(-std::numeric_limits<T>::infinity()),
                  glm::vec<3, T>(std::numeric_limits<T>::infinity())};
    for (const std::uint32_t i : positives[p]) {
      const Bounds<T> one = bounds_of(solid.leaves[i].kind, solid.leaves[i].placement);
      box.low = glm::max(box.low, one.low);
      box.high = glm::min(box.high, one.high);
      products.leaves.push_back(i);
    }
    products.leaves.insert(products.leaves.end(), negatives[p].begin(), negatives[p].end());
    boxes.push_back(box);
  }
  products.hierarchy = Hierarchy<T>(boxes);
  products.complete = true;
  return products;
}

template Products<float> plain_products(const Solid<float>&);
template Products<double> plain_products(const Solid<double>&);

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

void with_each_instruction_set(const std::function<void(const char* name)>& run) {
  const auto choose = [](std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  };
  choose(0);
  for (const auto target : hwy::SupportedAndGeneratedTargets()) {
    choose(target);
    run(hwy::TargetName(target));
  }
  choose(0);
}

}  // namespace sir::test
