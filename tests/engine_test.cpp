// Every optimisation gives what the plain algorithm of Roth gives.
#include <gtest/gtest.h>

#include "tests/cases.h"
#include "tests/scene_builder.h"
#include "tracer/probe.h"
#include "tracer/render.h"

namespace sir {
namespace {

void expect_same_boundaries(const Scene& scene, std::uint64_t seed, bool aligned,
                            Precision precision) {
  const auto fast = make_prober(scene, precision, Engine::gates);
  const auto plain = make_prober(scene, precision, Engine::roth);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(-1.5, 1.5);
  for (int n = 0; n < 300; ++n) {
    glm::dvec3 o(any(random), any(random), any(random)), d(any(random), any(random), any(random));
    if (aligned) {
      // On the grid that the faces lie on, along axes and diagonals.
      o = glm::round(o * 4.0) / 4.0 + glm::dvec3(n % 2 ? 0.0 : 0.125);
      d = glm::round(d);
      if (d == glm::dvec3(0)) d.x = 1;
    }
    const auto a = fast->hits(o, d);
    const auto b = plain->hits(o, d);
    ASSERT_EQ(a.size(), b.size()) << "seed " << seed << " ray " << n;
    for (std::size_t i = 0; i < a.size(); ++i) {
      ASSERT_EQ(a[i].t, b[i].t);
      ASSERT_EQ(a[i].entering, b[i].entering);
      ASSERT_EQ(a[i].entering, i % 2 == (a[0].entering ? 0u : 1u))
          << "entering and leaving alternate";
      ASSERT_EQ(a[i].node, b[i].node) << "seed " << seed << " ray " << n << " hit " << i;
      ASSERT_EQ(a[i].face, b[i].face);
      ASSERT_EQ(a[i].surface, b[i].surface);
    }
  }
}

TEST(Engine, GatesGiveRothsBoundaries) {
  for (std::uint64_t seed = 0; seed < test::cases(150); ++seed)
    for (const bool aligned : {false, true})
      for (const auto precision : {Precision::double_, Precision::float_, Precision::long_double})
        expect_same_boundaries(test::random_scene(seed, 1 + static_cast<int>(seed) % 25, aligned),
                               seed, aligned, precision);
}

TEST(Engine, GatesGiveRothsImages) {
  RenderOptions options;
  options.size = {48, 36};
  for (std::uint64_t seed = 0; seed < test::cases(30); ++seed) {
    const Scene scene = test::random_scene(seed, 3 + static_cast<int>(seed) % 12, seed % 3 == 0);
    for (const auto precision : {Precision::double_, Precision::float_, Precision::long_double}) {
      options.precision = precision;
      options.trace.engine = Engine::gates;
      options.trace.packets = true;
      const auto packets = render(scene, options);
      options.trace.packets = false;
      const auto fast = render(scene, options);
      options.trace.engine = Engine::roth;
      const auto plain = render(scene, options);
      ASSERT_EQ(packets.planes, plain.planes) << seed;
      ASSERT_EQ(fast.planes, plain.planes) << seed;
      // A packet finds a primitive again for each part that it is in; single rays do not.
      ASSERT_LE(fast.counts.spans, plain.counts.spans);
    }
  }
}

TEST(Engine, FarRaysAreNotLostToTheBoxes) {
  // Seen from 1e7 away the computed roots wander; a box must not disagree.
  const Scene scene = test::random_scene(4, 12, false);
  const auto fast = make_prober(scene, Precision::double_, Engine::gates);
  const auto plain = make_prober(scene, Precision::double_, Engine::roth);
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> any(-1, 1);
  int hits = 0;
  for (int n = 0; n < 3000; ++n) {
    const glm::dvec3 target(any(random), any(random), any(random));
    const glm::dvec3 away = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
    const auto a = fast->hits(target + 1e7 * away, -away);
    const auto b = plain->hits(target + 1e7 * away, -away);
    ASSERT_EQ(a.size(), b.size()) << n;
    hits += static_cast<int>(a.size());
  }
  EXPECT_GT(hits, 300);
}

}  // namespace
}  // namespace sir
