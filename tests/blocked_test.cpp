// Whether a light is blocked, found without ordering the boundaries, is what the
// ordered list says.
#include <gtest/gtest.h>

#include "tests/cases.h"
#include "tests/scene_builder.h"
#include "tracer/hit.h"

namespace sir {
namespace {

template <typename T>
bool blocked_in_order(Classifier<T>& classifier, const RayCena<T>& ray, const RayStart<T>& start) {
  classifier.begin(ray, start, T(1));
  Boundary<T> first;
  bool met = classifier.next(first);
  while (met && first.t == 0) met = classifier.next(first);
  return met && first.t < 1 && !Numeric<T>::same_event(first.t, T(1));
}

struct Tally {
  int blocked = 0, open = 0;
  std::uint64_t fewer_spans = 0;
};

// Free rays between random points, and from what they hit to random lights.
template <typename T>
void compare(const Scene& scene, std::uint64_t seed, bool aligned, Tally& tally) {
  const Model<T> model(scene, {});
  Classifier<T> fast(model.solid), ordered(model.solid), roth(model.solid, Engine::roth);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(-2.5, 2.5);
  const auto point = [&] {
    glm::dvec3 p(any(random), any(random), any(random));
    if (aligned) p = glm::round(p * 4.0) / 4.0;
    return PointCena<T>{glm::vec<3, T>(p)};
  };
  const auto check = [&](const RayCena<T>& ray, const RayStart<T>& start, PointCena<T> light) {
    const bool expected = blocked_in_order(ordered, ray, start);
    ASSERT_EQ(fast.blocked(ray, start, clearance(model.solid, light)), expected) << "seed " << seed;
    ASSERT_EQ(fast.blocked(ray, start, T(0)), expected) << "seed " << seed;
    const bool by_roth = seed % 4 == 0 ? blocked_in_order(roth, ray, start) : expected;
    ASSERT_EQ(by_roth, expected) << "seed " << seed;
    ++(expected ? tally.blocked : tally.open);
    fast.blocked(ray, start, clearance(model.solid, light));
    ASSERT_LE(fast.spans(), ordered.spans());
    tally.fewer_spans += ordered.spans() - fast.spans();
  };
  for (int n = 0; n < 100; ++n) {
    const PointCena<T> from = point(), light = point();
    ASSERT_NO_FATAL_FAILURE(check({from, light - from}, {}, light));
    const RayCena<T> primary{from, point() - from};
    Classifier<T> finder(model.solid);
    finder.begin(primary);
    for (Boundary<T> boundary; finder.next(boundary);) {
      const Hit<T> hit = hit_at(model, primary, boundary);
      const PointCena<T> other = n % 5 ? point() : PointCena<T>{hit.point.v * T(3)};
      for (const auto& start : {hit.leaving_on_eye_side(), hit.leaving_through()})
        ASSERT_NO_FATAL_FAILURE(check({hit.point, other - hit.point}, start, other));
    }
  }
}

TEST(Blocked, IsWhatTheOrderedListSays) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < test::cases(160); ++seed)
    for (const bool aligned : {false, true}) {
      const Scene scene = test::random_scene(seed, 1 + static_cast<int>(seed) % 25, aligned);
      ASSERT_NO_FATAL_FAILURE(compare<double>(scene, seed, aligned, tally));
      ASSERT_NO_FATAL_FAILURE(compare<float>(scene, seed, aligned, tally));
    }
  EXPECT_GT(tally.blocked, 10000);
  EXPECT_GT(tally.open, 10000);
}

// Unions of products, as most scenes are: what is found early is found right.
TEST(Blocked, StopsAtTheFirstSolidInTheWay) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < test::cases(60); ++seed)
    for (const bool aligned : {false, true}) {
      test::SceneBuilder build;
      std::mt19937_64 random(seed);
      const Scene scene = build.finish(build.crowd(random, 31, aligned));
      ASSERT_NO_FATAL_FAILURE(compare<double>(scene, seed, aligned, tally));
      ASSERT_NO_FATAL_FAILURE(compare<float>(scene, seed, aligned, tally));
    }
  EXPECT_GT(tally.blocked, 10000);
  EXPECT_GT(tally.open, 10000);
  EXPECT_GT(tally.fewer_spans, 1000u);
}

}  // namespace
}  // namespace sir
