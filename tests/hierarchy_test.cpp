// Every walk of the hierarchy finds what a look at every box finds.
#include "tracer/hierarchy.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace sir {
namespace {

using Box = Bounds<double>;

std::vector<Box> random_boxes(std::uint64_t seed, int count) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<Box> boxes;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 low(any(random), any(random), any(random));
    const double size = std::exp2(-5 + 4 * any(random));
    boxes.push_back({low, low + size * glm::dvec3(1, any(random) + 1, 1)});
  }
  return boxes;
}

// Boxes that no axis tells apart, and boxes that shrink so fast that a plane can
// only ever cut off the largest.
std::vector<Box> same_boxes() { return std::vector<Box>(1000, Box{{0, 0, 0}, {1, 1, 1}}); }
std::vector<Box> shrinking_boxes() {
  std::vector<Box> boxes;
  for (int i = 0; i < 900; ++i) {
    const double x = std::exp2(-i);
    boxes.push_back({{x, 0, 0}, {1.5 * x, x, x}});
  }
  return boxes;
}

std::size_t depth_of(const Hierarchy<double>& hierarchy) {
  std::vector<std::size_t> depth(hierarchy.nodes().size(), 1);
  std::size_t most = 0;
  for (std::size_t n = 0; n < depth.size(); ++n) {
    most = std::max(most, depth[n]);
    const auto& node = hierarchy.nodes()[n];
    if (node.size == 0) depth[node.first] = depth[node.first + 1] = depth[n] + 1;
  }
  return most;
}

// Parts of which nothing is left have boxes whose low ends lie above their high ones, anywhere.
// Their common envelope has no size, in units of which they would be infinitely far.
TEST(Hierarchy, EmptyBoxesMayLieAnywhere) {
  std::vector<Box> boxes;
  for (int i = 0; i < 40; ++i) {
    const glm::dvec3 low(i % 7 - 3.0, i % 5, 0.25 * i);
    boxes.push_back({low + 20.0, low - 20.0 * (i % 3)});
  }
  const Hierarchy<double> hierarchy(boxes);
  std::set<std::uint32_t> seen;
  for (const auto& node : hierarchy.nodes())
    for (std::uint32_t i = 0; i < node.size; ++i) seen.insert(hierarchy.order()[node.first + i]);
  EXPECT_EQ(seen.size(), boxes.size());
}

TEST(Hierarchy, NoBoxIsLostOnAWalk) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  int met = 0;
  for (int n = 0; n < 40; ++n) {
    const auto boxes = n == 0   ? same_boxes()
                       : n == 1 ? shrinking_boxes()
                                : random_boxes(random(), 1 + n * n);
    const Hierarchy<double> hierarchy(boxes);
    EXPECT_LE(depth_of(hierarchy), Hierarchy<double>::kMaxDepth);
    for (int k = 0; k < 30; ++k) {
      const glm::dvec3 origin(any(random), any(random), any(random));
      glm::dvec3 direction(any(random), any(random), any(random));
      if (k % 3 == 0) direction[k % 2] = 0;
      const RayCena<double> ray{{origin}, {direction}};
      const double farthest = k % 4 ? 1.0 : std::numeric_limits<double>::infinity();
      const BoxProbe<double> probe(ray);
      std::set<std::uint32_t> expected, any_order, in_order;
      for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (probe.meets(boxes[i], farthest)) expected.insert(i);
      hierarchy.for_each_met(probe, farthest, [&](std::uint32_t i) {
        any_order.insert(i);
        return false;
      });
      hierarchy.for_each_met_in_order(probe, farthest, [&](std::uint32_t i, double limit) {
        in_order.insert(i);
        return limit;
      });
      EXPECT_EQ(any_order, expected);
      EXPECT_EQ(in_order, expected);
      met += static_cast<int>(expected.size());

      // Narrowing to the nearest entry still finds the nearest.
      double nearest = farthest, least = farthest;
      for (const std::uint32_t i : expected)
        least = std::min(least, probe.entry(boxes[i], farthest));
      hierarchy.for_each_met_in_order(probe, farthest, [&](std::uint32_t i, double limit) {
        EXPECT_LE(limit, nearest);
        const double entry = probe.entry(boxes[i], limit);
        return nearest = entry < limit ? entry : limit;
      });
      EXPECT_EQ(nearest, least);

      const Box around{origin - 0.1, origin + 0.1};
      std::set<std::uint32_t> near, found;
      for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (boxes[i].near(around, 0.05)) near.insert(i);
      hierarchy.for_each_near(around, 0.05, [&](std::uint32_t i) {
        found.insert(i);
        return false;
      });
      EXPECT_EQ(found, near);
    }
  }
  EXPECT_GT(met, 1000);
}

TEST(Hierarchy, AVisitorMayEndTheWalk) {
  const auto boxes = same_boxes();
  const Hierarchy<double> hierarchy(boxes);
  const BoxProbe<double> probe(RayCena<double>{{{-1, 0.5, 0.5}}, {{1, 0, 0}}});
  int visits = 0;
  hierarchy.for_each_met_in_order(probe, 10.0, [&](std::uint32_t, double) {
    ++visits;
    return -1.0;
  });
  EXPECT_EQ(visits, 1);
}

TEST(Hierarchy, OfNothingHasNothing) {
  const Hierarchy<double> hierarchy(std::span<const Box>{});
  const BoxProbe<double> probe(RayCena<double>{{{0, 0, 0}}, {{1, 0, 0}}});
  hierarchy.for_each_met_in_order(probe, 10.0, [](std::uint32_t, double limit) {
    ADD_FAILURE();
    return limit;
  });
  EXPECT_TRUE(hierarchy.nodes().empty());
}

}  // namespace
}  // namespace sir
