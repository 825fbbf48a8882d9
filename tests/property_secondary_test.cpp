// Rays that leave a surface: mirrored, refracted, towards a light.
#include "tests/property_membership.h"
#include "tests/property_tally.h"
#include "tracer/hit.h"
#include "tracer/ray_secondary.h"
#include "tracer/trace.h"

namespace sir {
namespace {

using test::Membership;
using test::Random;
using test::Regime;
using test::Side;
using test::TestRay;

template <typename T>
double largest(const glm::vec<3, T>& v) {
  return glm::max(std::abs(double(v.x)), glm::max(std::abs(double(v.y)), std::abs(double(v.z))));
}

template <typename T>
std::vector<Boundary<T>> boundaries(Classifier<T>& classifier, const RayCena<T>& ray,
                                    const RayStart<T>& start = {}) {
  std::vector<Boundary<T>> found;
  classifier.begin(ray, start);
  for (Boundary<T> boundary; classifier.next(boundary);) found.push_back(boundary);
  return found;
}

/// A ray from a hit, and on which side of the solid it begins.
template <typename T>
struct Leaving {
  const char* kind;
  VectorCena<T> direction;
  RayStart<T> start;
  bool inside;
};

template <typename T>
std::vector<Leaving<T>> rays_from(const Hit<T>& hit, Random& random) {
  const bool eye_inside = !hit.boundary.entering;
  std::vector<Leaving<T>> rays;
  rays.push_back(
      {"mirrored", mirrored(hit.incident, hit.normal), hit.leaving_on_eye_side(), eye_inside});
  constexpr double kRatios[] = {1, 1.5, 1 / 1.5, 4, 0.25};
  VectorCena<T> through;
  if (refracted(hit.incident, hit.normal, T(kRatios[random.below(5)]), T(1), through))
    rays.push_back({"refracted", through, hit.leaving_through(), !eye_inside});
  const PointCena<T> light{glm::vec<3, T>(3.0 * random.direction())};
  if (dot(hit.normal, light - hit.point) > 0)
    rays.push_back({"to a light", light - hit.point, hit.leaving_on_eye_side(), eye_inside});
  return rays;
}

// Follows secondary rays of a solid and compares every stretch between their
// boundaries, and points before the first one, with exact membership. A false
// hit of the surface that was left, or one that is lost, turns the rest of the
// ray to the wrong side. Only within roundings of its start may a ray change
// sides unseen: in an edge, or along the surface.
template <typename T>
class Follower {
 public:
  Follower(const Scene& scene, test::Tally& tally)
      : model_(scene, {}), classifier_(model_.solid), membership_(scene), tally_(tally) {}

  void follow(const TestRay& primary, Random& random, std::uint64_t seed, Regime regime) {
    const RayCena<T> ray{{glm::vec<3, T>(primary.origin)}, {glm::vec<3, T>(primary.direction)}};
    for (const Boundary<T>& boundary : boundaries(classifier_, ray)) {
      const Hit<T> hit = hit_at(model_, ray, boundary);
      // What the start may be off by comes from the first ray's coordinates.
      const double extent =
          largest(primary.origin) + double(boundary.t) * largest(primary.direction);
      for (const Leaving<T>& leaving : rays_from(hit, random)) {
        const std::string wrong = compare(hit, leaving, extent);
        if (!wrong.empty()) tally_.fail(seed, regime, primary, std::string(leaving.kind) + wrong);
      }
    }
  }

 private:
  std::string compare(const Hit<T>& hit, const Leaving<T>& leaving, double extent) {
    const RayCena<T> ray{hit.point, leaving.direction};
    const auto found = boundaries(classifier_, ray, leaving.start);
    ++tally_.rays;
    tally_.hits += found.size();
    const bool convex = model_.solid.leaves.size() == 1;
    if (convex && found.size() > (leaving.inside ? 1u : 0u)) return ", convex: a false hit";
    bool inside = !found.empty() && !found.front().entering;
    if (inside != leaving.inside) ++tally_.undecided;
    const double first = found.empty() ? 4 / largest(ray.direction.v) : double(found.front().t);
    for (double t = first; t > first * 1e-6; t *= 0.03)
      if (wrong_side(ray, t * 0.99, inside, extent)) return ": wrong side near its start";
    double from = 0;
    for (const Boundary<T>& boundary : found) {
      const double t = double(boundary.t);
      if (!std::isfinite(t) || !(t > 0)) return ": t is no place on the ray";
      if (boundary.entering == inside) return ": sides do not alternate";
      if (wrong_side(ray, from / 2 + t / 2, inside, extent))
        return ": wrong side before t = " + std::to_string(t);
      inside = boundary.entering;
      from = t;
    }
    if (inside) return ": never leaves";
    return {};
  }

  bool wrong_side(const RayCena<T>& ray, double t, bool inside, double extent) {
    const glm::dvec3 o(ray.origin.v), d(ray.direction.v);
    // The point that is asked for is a double however wide T is.
    const Side side = membership_.of(o + t * d, extent + largest(o) + t * largest(d),
                                     double(Numeric<T>::kEpsilon * Numeric<T>::kGrain));
    ++(side == Side::undecided ? tally_.undecided : tally_.decided);
    return side != Side::undecided && (side == Side::inside) != inside;
  }

  Model<T> model_;
  Classifier<T> classifier_;
  Membership membership_;
  test::Tally& tally_;
};

class PropertySecondary : public test::InRegime {
 protected:
  Scene scene(std::uint64_t seed, int leaves) const {
    Random random(seed);
    test::SceneBuilder build;
    return build.finish(test::add_random_solid(build, random, GetParam(), leaves));
  }

  template <typename T>
  void follow(test::Tally& tally, std::uint64_t seed, int leaves) const {
    const Scene made = scene(seed, leaves);
    Follower<T> follower(made, tally);
    Random random(seed * 81);
    for (int n = 0; n < 100; ++n)
      follower.follow(test::random_ray(made, random, GetParam()), random, seed, GetParam());
  }
};
SIR_IN_EVERY_REGIME(PropertySecondary);

TEST_P(PropertySecondary, NeverMeetAConvexSolidAgain) {
  test::Tally tally("leaving one primitive", 0.6);
  for (std::uint64_t seed = 1; tally.wants_more(); ++seed) {
    follow<double>(tally, seed, 1);
    follow<float>(tally, seed, 1);
    follow<long double>(tally, seed, 1);
    tally.progress();
  }
}

TEST_P(PropertySecondary, GoOnOnTheirSide) {
  test::Tally tally("leaving a composite", 1.4);
  for (std::uint64_t seed = 1; tally.wants_more(); ++seed) {
    const int leaves = 2 + static_cast<int>(seed % 20);
    follow<double>(tally, seed, leaves);
    follow<float>(tally, seed, leaves);
    follow<long double>(tally, seed, leaves);
    tally.progress();
  }
}

// A round hole, or a conical pit, that is flush with the top of a block. A ray
// that goes through the rim into it is in the open until the far side: the side
// that the ray stands on is not where it leaves the hole.
TEST(SecondaryRim, RayThroughTheRimOfAHoleIsInTheHole) {
  for (const bool cylinder : {true, false})
    for (const double turn : {0.0, 0.5, 2.0}) {
      test::SceneBuilder build;
      const auto block = build.cube({-4, -4, -4}, {4, 1, 4});
      Placement placement = test::placed({1, cylinder ? 1 : -1, 1}, {0, cylinder ? 0 : 1, 0});
      const auto hole =
          build.primitive(cylinder ? PrimitiveKind::cylinder : PrimitiveKind::cone, placement, 2);
      const Scene scene = build.finish(build.combine(Operation::difference, block, hole));
      const Model<double> model(scene, {});
      Classifier<double> classifier(model.solid);
      const glm::dvec3 outward(std::cos(turn), 0, std::sin(turn));
      const RayCena<double> down{{outward + glm::dvec3(0, 3, 0)}, {{0, -1, 0}}};
      const auto top = boundaries(classifier, down);
      if (turn == 0) {
        ASSERT_FALSE(top.empty());
      }
      if (top.empty() || top[0].face != 3 || model.solid.leaves[top[0].leaf].node != 0) continue;
      const auto hit = hit_at(model, down, top[0]);
      const RayCena<double> across{hit.point, {-outward + glm::dvec3(0, -0.125, 0)}};
      const auto found = boundaries(classifier, across, hit.leaving_through());
      ASSERT_EQ(found.size(), 2u) << cylinder << " " << turn;
      EXPECT_TRUE(found[0].entering);
      // Where x = 2 - t: the cylinder's far side, or the pit's, whose radius
      // falls by t/8.
      EXPECT_NEAR(found[0].t, cylinder ? 2 : 2 / 1.125, 1e-12);
    }
}

// Refracted and sent back, a ray comes back. A rounding of the refracted
// direction moves its sine by epsilon, that of the way back by n2/n1 as much,
// and the angle by 1/cos of that.
TEST(PropertyRefraction, ReversedReturnsTheRay) {
  test::Tally tally("refraction reversed", 15);
  Random random(82);
  const auto check = [&]<typename T>(T) {
    const double epsilon = double(Numeric<T>::kEpsilon);
    const auto n1 = static_cast<T>(std::pow(10.0, random.between(-1, 1)));
    const auto n2 = static_cast<T>(std::pow(10.0, random.between(-1, 1)));
    const auto normal = normalize(VectorCena<T>{glm::vec<3, T>(random.direction())});
    auto incident = normalize(VectorCena<T>{glm::vec<3, T>(random.direction())});
    if (dot(incident, normal) > 0) incident = -incident;
    VectorCena<T> through, back;
    ++tally.rays;
    if (!refracted(incident, normal, n1, n2, through)) return;
    ++tally.hits;
    const double cosine = -double(dot(incident, normal));
    const double condition = (1 + double(n2) / double(n1)) / cosine;
    if (!(cosine > 0) || condition * epsilon > cosine / 32) {
      ++tally.undecided;  // so flat that it may be turned back
      return;
    }
    ++tally.decided;
    const bool returned = refracted(-through, -normal, n2, n1, back);
    const double miss = returned ? double(length(back + incident)) : 2;
    if (!(miss <= 8 * epsilon * condition))
      tally.fail(tally.rays, Regime::generic, {glm::dvec3(incident.v), glm::dvec3(normal.v)},
                 "n1, n2 = " + std::to_string(n1) + ", " + std::to_string(n2) + " misses by " +
                     std::to_string(miss / epsilon) + " epsilon; cosine " + std::to_string(cosine));
  };
  while (tally.wants_more()) {
    for (int n = 0; n < 1000; ++n) check(1.0);
    for (int n = 0; n < 1000; ++n) check(1.0f);
    tally.progress();
  }
}

// A matt primitive, of sizes 2^-20 to 2^20, moved, before one light: where the
// exact normal has N.L > 0 the light arrives, and where N.L < 0 it does not.
template <typename T>
void expect_lit(std::uint64_t seed, test::Tally& tally) {
  Random random(seed);
  test::SceneBuilder build;
  constexpr PrimitiveKind kKinds[] = {PrimitiveKind::cube, PrimitiveKind::sphere,
                                      PrimitiveKind::cone, PrimitiveKind::cylinder};
  constexpr double kSizes[] = {0x1p-20, 1, 0x1p20};
  const double size = kSizes[random.below(3)];
  Placement placement = test::random_placement(random.engine(), 1, random.once_in(2));
  const auto root = build.primitive(kKinds[random.below(4)], placement);
  build.scene.lighting.lights = {{4.0 * random.direction(), glm::dvec3(1)}};
  // Moved by some of its sizes: farther, and its own numbers are too coarse.
  const Scene scene =
      test::moved(build.finish(root), size, size * random.between(0, 30) * random.direction());
  const Model<T> model(scene, {});
  Tracer<T> tracer(model, {});
  for (int n = 0; n < 100; ++n) {
    const TestRay ray = test::random_ray(scene, random, Regime::generic);
    TraceLog log;
    tracer.radiance({{glm::vec<3, T>(ray.origin)}, {glm::vec<3, T>(ray.direction)}}, &log);
    ++tally.rays;
    if (!log[0].hit) continue;
    ++tally.hits;
    const CsgNode& node = scene.tree.nodes[scene.tree.root];
    const glm::dmat3 inverse = glm::inverse(node.placement.linear);
    const glm::dvec3 local = inverse * (log[0].point - node.placement.translation);
    const auto outward = outward_normal(node.kind, log[0].face, PointLocal<double>{local});
    glm::dvec3 normal = glm::normalize(outward.v * inverse);
    if (glm::dot(normal, ray.direction) > 0) normal = -normal;
    const glm::dvec3 to_light = scene.lighting.lights[0].position - log[0].point;
    const double cosine = glm::dot(normal, glm::normalize(to_light));
    // From inside the far wall of the solid lies before the light.
    const bool from_inside = !log[0].entering;
    const double roundings = sizeof(T) == sizeof(float) ? 1e-3 : 1e-9;
    if (std::abs(cosine) < roundings || from_inside) {
      ++tally.undecided;
      continue;
    }
    ++tally.decided;
    if ((log[0].lights[0].x > 0) != (cosine > 0))
      tally.fail(seed, Regime::generic, ray, "N.L = " + std::to_string(cosine));
  }
}

TEST(PropertyLit, ConvexSolidHasNoDarkPixelOnItsLitSide) {
  test::Tally tally("lit convex solid", 3);
  for (std::uint64_t seed = 1; tally.wants_more(); ++seed) {
    expect_lit<double>(seed, tally);
    expect_lit<float>(seed, tally);
    expect_lit<long double>(seed, tally);
    tally.progress();
  }
}

}  // namespace
}  // namespace sir
