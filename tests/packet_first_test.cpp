// The first boundaries of sixteen rays at once are the Classifier's.
#include <gtest/gtest.h>

#include <bit>
#include <sstream>

#include "tests/cases.h"
#include "tests/instruction_sets.h"
#include "tests/packet_scenes.h"
#include "tracer/hit.h"
#include "tracer/packet_first.h"
#include "tracer/ray_secondary.h"

namespace sir {
namespace {

template <typename T>
auto bits_of(T number) {
  if constexpr (sizeof(T) == 4) return std::bit_cast<std::uint32_t>(number);
  else return std::bit_cast<std::uint64_t>(number);
}

struct FirstTally {
  int hits = 0, misses = 0, doubtful = 0, exits = 0;
  int lanes() const { return hits + misses + doubtful; }
  double share_doubtful() const { return double(doubtful) / lanes(); }
};

// Rays from an eye, mirrored ones, and ones that go on through the surface.
struct FirstTallies {
  FirstTally free, mirrored, through;
};

// What a packet is certain of is what the Classifier finds.
template <typename T>
void compare_first(const Solid<T>& solid, const PacketSolid<T>& packets, const RayPacket<T>& packet,
                   FirstTally& tally) {
  Classifier<T> classifier(solid);
  const PacketFirst<T> found = first_boundaries(packets, packet);
  ASSERT_EQ(found.hit | found.missed | found.doubtful, packet.active);
  ASSERT_EQ(
      (found.hit & found.missed) | (found.hit & found.doubtful) | (found.missed & found.doubtful),
      0u);
  for (std::size_t lane = 0; lane < kPacketLanes; ++lane) {
    const std::uint32_t bit = 1u << lane;
    if (!(packet.active & bit)) continue;
    if (found.doubtful & bit) {
      ++tally.doubtful;
      continue;
    }
    classifier.begin(packet.ray(lane), packet.start(lane));
    Boundary<T> expected;
    const bool met = classifier.next(expected);
    const auto where = [&] {
      const auto ray = packet.ray(lane);
      std::ostringstream out;
      out.precision(20);
      for (int i = 0; i < 3; ++i) out << ray.origin.v[i] << ' ' << ray.direction.v[i] << "  ";
      out << "start " << packet.start_leaf[lane] << " expected " << met << " t " << expected.t
          << " leaf " << expected.leaf << " got " << (found.hit & bit) << ' '
          << found.boundary[lane].t << " leaf " << found.boundary[lane].leaf;
      return out.str();
    };
    ASSERT_EQ((found.hit & bit) != 0, met) << where();
    if (!met) {
      ++tally.misses;
      continue;
    }
    ++tally.hits;
    const Boundary<T>& got = found.boundary[lane];
    ASSERT_EQ(got.leaf, expected.leaf) << where();
    ASSERT_EQ(got.face, expected.face) << where();
    ASSERT_EQ(got.entering, expected.entering) << where();
    ASSERT_EQ(got.leaf_entering, expected.leaf_entering) << where();
    tally.exits += !got.entering;
    Boundary<T> first;
    ASSERT_TRUE(classifier.first(packet.ray(lane), packet.start(lane), first)) << where();
    ASSERT_EQ(bits_of(got.t), bits_of(first.t)) << where();
    ASSERT_EQ(bits_of(got.error), bits_of(first.error)) << where();
    ASSERT_EQ(bits_of(got.t), bits_of(expected.t)) << where();
    ASSERT_EQ(bits_of(got.error), bits_of(expected.error)) << where();
  }
}

// Bundles from a common point and rays at random; then mirrored and refracted ones
// from what these hit.
template <typename T>
void compare_scene(const Scene& scene, std::uint64_t seed, int packets_of_rays,
                   FirstTallies& tallies) {
  const Model<T> model(scene, {});
  ASSERT_TRUE(model.solid.products.complete);
  const PacketSolid<T> packets(model.solid);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(-3, 3);
  const auto point = [&] { return glm::dvec3(any(random), any(random), any(random)); };
  Classifier<T> classifier(model.solid);
  for (int n = 0; n < packets_of_rays; ++n) {
    RayPacket<T> packet, outside, through;
    const glm::dvec3 eye = point() * (n % 3 ? 2.0 : 0.5), target = point();
    for (std::size_t lane = 0; lane < kPacketLanes; ++lane) {
      const glm::dvec3 aim = n % 4 ? target + point() * 0.05 : point();
      const RayCena<T> ray{{glm::vec<3, T>(eye)}, {glm::vec<3, T>(aim - eye)}};
      packet.set(lane, ray);
      classifier.begin(ray);
      Boundary<T> boundary;
      if (!classifier.next(boundary)) continue;
      // Rays that begin inside of two parts at once are the Classifier's: apart.
      const bool inside = n % 5 == 0 ? classifier.next(boundary) : !boundary.entering;
      const Hit<T> hit = hit_at(model, ray, boundary);
      (inside ? through : outside)
          .set(lane, {hit.point, mirrored(hit.incident, hit.normal)}, hit.leaving_on_eye_side());
      if (!inside) through.set(lane, {hit.point, hit.incident}, hit.leaving_through());
    }
    ASSERT_NO_FATAL_FAILURE(compare_first(model.solid, packets, packet, tallies.free));
    ASSERT_NO_FATAL_FAILURE(compare_first(model.solid, packets, outside, tallies.mirrored));
    ASSERT_NO_FATAL_FAILURE(compare_first(model.solid, packets, through, tallies.through));
  }
}

template <typename T>
void compare_scenes(bool aligned, FirstTallies& tallies) {
  for (std::uint64_t seed = 0; seed < test::cases(120); ++seed) {
    const int parts = 1 + static_cast<int>(seed) % 40;
    const double size = seed % 3 ? 0.4 : 1.2;
    ASSERT_NO_FATAL_FAILURE(
        compare_scene<T>(test::union_of_parts(seed, parts, size, aligned), seed, 40, tallies))
        << "seed " << seed;
  }
  for (const FirstTally& tally : {tallies.free, tallies.mirrored, tallies.through}) {
    EXPECT_GT(tally.hits, 1500);
    EXPECT_GT(tally.misses, 300);
  }
  EXPECT_GT(tallies.free.exits, 100);
  EXPECT_GT(tallies.through.exits, 100);
}

// How many lanes went which way: the same on every instruction set.
template <typename T>
std::vector<int> compare_scenes(bool aligned, double most_doubtful) {
  FirstTallies tallies;
  compare_scenes<T>(aligned, tallies);
  EXPECT_LT(tallies.free.share_doubtful(), most_doubtful);
  EXPECT_LT(tallies.mirrored.share_doubtful(), most_doubtful);
  EXPECT_LT(tallies.through.share_doubtful(), aligned ? 0.3 : 0.12);  // in two parts at once
  std::vector<int> counts;
  for (const FirstTally& tally : {tallies.free, tallies.mirrored, tallies.through})
    counts.insert(counts.end(), {tally.hits, tally.misses, tally.doubtful, tally.exits});
  return counts;
}

void compare_on_each_instruction_set(bool aligned, double most_doubtful) {
  std::vector<std::vector<int>> counts;
  test::with_each_instruction_set([&](const char* set) {
    SCOPED_TRACE(set);
    counts.push_back(compare_scenes<double>(aligned, most_doubtful));
    counts.push_back(compare_scenes<float>(aligned, most_doubtful));
    EXPECT_EQ(counts[counts.size() - 2], counts[0]);
    EXPECT_EQ(counts[counts.size() - 1], counts[1]);
  });
  EXPECT_GE(counts.size(), 2u);
}

TEST(PacketFirst, IsTheClassifiersWherePartsLieAnyhow) {
  compare_on_each_instruction_set(false, 0.02);
}

TEST(PacketFirst, IsTheClassifiersWhereFacesCoincide) {
  compare_on_each_instruction_set(true, 0.2);
}

}  // namespace
}  // namespace sir
