// Whether a light is blocked, asked for sixteen rays at once.
#include <gtest/gtest.h>

#include "tests/cases.h"
#include "tests/instruction_sets.h"
#include "tests/packet_scenes.h"
#include "tracer/hit.h"
#include "tracer/packet_blocked.h"

namespace sir {
namespace {

struct BlockedTally {
  int blocked = 0, open = 0, doubtful = 0;
  double share_doubtful() const { return double(doubtful) / (blocked + open + doubtful); }
};

template <typename T>
void compare_packet(Classifier<T>& classifier, const PacketSolid<T>& packets,
                    const RayPacket<T>& packet, T clear, BlockedTally& tally) {
  const PacketBlocked found = find_blocked(packets, packet, clear);
  ASSERT_EQ(found.blocked | found.open | found.doubtful, packet.active);
  ASSERT_EQ((found.blocked & found.open) | (found.blocked & found.doubtful) |
                (found.open & found.doubtful),
            0u);
  for (std::size_t lane = 0; lane < kPacketLanes; ++lane) {
    const std::uint32_t bit = 1u << lane;
    if (!(packet.active & bit)) continue;
    if (found.doubtful & bit) {
      tally.doubtful += clear > 0;  // else it must be
      continue;
    }
    const bool expected = classifier.blocked(packet.ray(lane), packet.start(lane), clear);
    ASSERT_EQ((found.blocked & bit) != 0, expected) << "lane " << lane;
    ++(expected ? tally.blocked : tally.open);
  }
}

// From what rays hit to lights outside and inside of the solid, and free rays.
template <typename T>
void compare_scene(const Scene& scene, std::uint64_t seed, BlockedTally& secondary,
                   BlockedTally& free) {
  const Model<T> model(scene, {});
  ASSERT_TRUE(model.solid.products.complete);
  const PacketSolid<T> packets(model.solid);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(-3, 3);
  const auto point = [&] { return glm::dvec3(any(random), any(random), any(random)); };
  Classifier<T> classifier(model.solid);
  for (int n = 0; n < 40; ++n) {
    RayPacket<T> packet, free_packet;
    const glm::dvec3 eye = point() * 2.0, target = point();
    const PointCena<T> light{glm::vec<3, T>(point() * (n % 4 ? 2.0 : 0.7))};
    const T clear = n % 16 ? clearance(model.solid, light) : T(0);
    for (std::size_t lane = 0; lane < kPacketLanes; ++lane) {
      const PointCena<T> from{glm::vec<3, T>(target + point() * 0.3)};
      free_packet.set(lane, {from, light - from});
      const RayCena<T> ray{{glm::vec<3, T>(eye)}, {glm::vec<3, T>(target + point() * 0.1 - eye)}};
      classifier.begin(ray);
      Boundary<T> boundary;
      if (!classifier.next(boundary)) continue;
      const Hit<T> hit = hit_at(model, ray, boundary);
      packet.set(lane, {hit.point, light - hit.point}, hit.leaving_on_eye_side());
    }
    ASSERT_NO_FATAL_FAILURE(compare_packet(classifier, packets, packet, clear, secondary));
    ASSERT_NO_FATAL_FAILURE(compare_packet(classifier, packets, free_packet, clear, free));
    if (clear > 0) continue;
    ASSERT_EQ(find_blocked(packets, packet, clear).doubtful, packet.active);
  }
}

template <typename T>
void compare_scenes(bool aligned, double most_doubtful) {
  BlockedTally secondary, free;
  for (std::uint64_t seed = 0; seed < test::cases(120); ++seed) {
    const int parts = 1 + static_cast<int>(seed) % 40;
    const Scene scene = test::union_of_parts(seed, parts, seed % 3 ? 0.4 : 1.2, aligned);
    ASSERT_NO_FATAL_FAILURE(compare_scene<T>(scene, seed, secondary, free)) << "seed " << seed;
  }
  for (const BlockedTally& tally : {secondary, free}) {
    EXPECT_GT(tally.blocked, 3000);
    EXPECT_GT(tally.open, 3000);
    EXPECT_LT(tally.share_doubtful(), most_doubtful);
  }
}

TEST(PacketBlocked, IsTheClassifiersWherePartsLieAnyhow) {
  test::with_each_instruction_set([](const char* set) {
    SCOPED_TRACE(set);
    compare_scenes<double>(false, 0.02);
    compare_scenes<float>(false, 0.02);
  });
}

TEST(PacketBlocked, IsTheClassifiersWhereFacesCoincide) {
  test::with_each_instruction_set([](const char* set) {
    SCOPED_TRACE(set);
    compare_scenes<double>(true, 0.2);
    compare_scenes<float>(true, 0.2);
  });
}

}  // namespace
}  // namespace sir
