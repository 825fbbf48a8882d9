// The first boundary, found without the others, is the first of the ordered list.
#include <gtest/gtest.h>

#include "tests/cases.h"
#include "tests/scene_builder.h"
#include "tracer/hit.h"

namespace sir {
namespace {

struct Tally {
  int met = 0, missed = 0, other_digits = 0;
  std::uint64_t fewer_spans = 0;
};

template <typename T>
void compare(const Scene& scene, std::uint64_t seed, bool aligned, Tally& tally) {
  const Model<T> model(scene, {});
  Classifier<T> fast(model.solid), ordered(model.solid);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(-2.5, 2.5);
  const auto point = [&] {
    glm::dvec3 p(any(random), any(random), any(random));
    if (aligned) p = glm::round(p * 4.0) / 4.0;
    return PointCena<T>{glm::vec<3, T>(p)};
  };
  const auto check = [&](const RayCena<T>& ray, const RayStart<T>& start) {
    ordered.begin(ray, start);
    Boundary<T> expected, found;
    const bool met = ordered.next(expected);
    ASSERT_EQ(fast.first(ray, start, found), met) << "seed " << seed;
    ++(met ? tally.met : tally.missed);
    tally.fewer_spans += fast.spans() < ordered.spans() ? ordered.spans() - fast.spans() : 0;
    if (!met) return;
    EXPECT_EQ(found.leaf, expected.leaf) << "seed " << seed;
    EXPECT_EQ(found.face, expected.face) << "seed " << seed;
    EXPECT_EQ(found.entering, expected.entering) << "seed " << seed;
    EXPECT_EQ(found.leaf_entering, expected.leaf_entering) << "seed " << seed;
    if (found.t == expected.t && found.error == expected.error) return;
    // Something that is not there made the list look closer.
    ++tally.other_digits;
    EXPECT_LE(std::abs(found.t - expected.t),
              found.error + expected.error + 2 * Numeric<T>::kEpsilon * expected.t)
        << "seed " << seed;
  };
  for (int n = 0; n < 60; ++n) {
    const PointCena<T> from = point();
    const RayCena<T> primary{from, point() - from};
    ASSERT_NO_FATAL_FAILURE(check(primary, {}));
    Classifier<T> finder(model.solid);
    finder.begin(primary);
    for (Boundary<T> boundary; finder.next(boundary);) {
      const Hit<T> hit = hit_at(model, primary, boundary);
      const PointCena<T> other = n % 5 ? point() : PointCena<T>{hit.point.v * T(3)};
      for (const auto& start : {hit.leaving_on_eye_side(), hit.leaving_through()})
        ASSERT_NO_FATAL_FAILURE(check({hit.point, other - hit.point}, start));
    }
  }
}

template <typename T>
class FirstHit : public testing::Test {};
using Scalars = testing::Types<float, double, long double>;
TYPED_TEST_SUITE(FirstHit, Scalars);

TYPED_TEST(FirstHit, IsTheFirstOfTheList) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < test::cases(200); ++seed)
    for (const bool aligned : {false, true})
      ASSERT_NO_FATAL_FAILURE(
          compare<TypeParam>(test::random_scene(seed, 1 + static_cast<int>(seed) % 25, aligned),
                             seed, aligned, tally));
  EXPECT_GT(tally.met, 10000);
  EXPECT_GT(tally.missed, 10000);
  EXPECT_GT(tally.fewer_spans, 1000u);
  EXPECT_LT(tally.other_digits, (tally.met + tally.missed) / 1000);
  this->RecordProperty("other_digits", tally.other_digits);
}

// With a piece cut off every other time.
Scene crowd(std::uint64_t seed, bool aligned) {
  test::SceneBuilder build;
  std::mt19937_64 random(seed);
  auto root = build.crowd(random, 41, aligned);
  if (seed % 2)
    root = build.combine(Operation::difference, root, build.cube({-0.5, -0.5, -0.5}, {3, 3, 3}));
  return build.finish(root);
}

TYPED_TEST(FirstHit, IsTheFirstOfManyParts) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < test::cases(80); ++seed)
    for (const bool aligned : {false, true})
      ASSERT_NO_FATAL_FAILURE(compare<TypeParam>(crowd(seed, aligned), seed, aligned, tally));
  EXPECT_GT(tally.met, 10000);
  EXPECT_GT(tally.missed, 5000);
  EXPECT_GT(tally.fewer_spans, 10000u);
  EXPECT_LT(tally.other_digits, (tally.met + tally.missed) / 1000);
  this->RecordProperty("other_digits", tally.other_digits);
}

// Seen from so far away that what is one event reaches from part to part.
TYPED_TEST(FirstHit, FromFarAway) {
  using T = TypeParam;
  int met = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Model<T> model(crowd(seed, seed % 3 == 0), {});
    Classifier<T> fast(model.solid), ordered(model.solid);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    for (const double distance : {1e2, 1e4, 1e6, 1e8, 1e12, 1e15})
      for (int n = 0; n < 100; ++n) {
        const glm::dvec3 target(any(random), any(random), any(random));
        const glm::dvec3 away = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
        const RayCena<T> ray{{glm::vec<3, T>(target + distance * away)}, {glm::vec<3, T>(-away)}};
        ordered.begin(ray);
        Boundary<T> expected, found;
        ASSERT_EQ(fast.first(ray, {}, found), ordered.next(expected)) << seed << " " << distance;
        EXPECT_EQ(found.leaf, expected.leaf);
        EXPECT_EQ(found.face, expected.face);
        EXPECT_EQ(found.entering, expected.entering);
        EXPECT_LE(std::abs(found.t - expected.t),
                  found.error + expected.error + 2 * Numeric<T>::kEpsilon * expected.t);
        met += expected.t > 0;
      }
  }
  EXPECT_GT(met, 500);
}

}  // namespace
}  // namespace sir
