// Shading where its numbers are hardest. What is expected comes from formulas
// of this file in a hundred digits, or from a scene that must look the same.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "tests/scene_builder.h"
#include "tracer/ray_secondary.h"
#include "tracer/shade.h"
#include "tracer/trace.h"

namespace sir {
namespace {

using boost::multiprecision::cpp_bin_float_100;
using Exact = cpp_bin_float_100;
using test::SceneBuilder;

struct ExactVector {
  Exact x, y, z;
  template <typename T>
  explicit ExactVector(const glm::vec<3, T>& v) : x(v.x), y(v.y), z(v.z) {}
  ExactVector(Exact a, Exact b, Exact c) : x(std::move(a)), y(std::move(b)), z(std::move(c)) {}
  ExactVector operator+(const ExactVector& o) const { return {x + o.x, y + o.y, z + o.z}; }
  ExactVector operator-(const ExactVector& o) const { return {x - o.x, y - o.y, z - o.z}; }
  ExactVector operator*(const Exact& f) const { return {x * f, y * f, z * f}; }
};
Exact dot(const ExactVector& a, const ExactVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
ExactVector unit(const ExactVector& a) { return a * (1 / sqrt(dot(a, a))); }

// Snell's law for the directions of I and N, whatever their lengths were
// rounded to: sin of the angle beyond, and the direction where sin <= 1.
struct Snell {
  Exact sine;
  ExactVector direction{0, 0, 0};
  template <typename T>
  Snell(VectorCena<T> incident, VectorCena<T> normal, T n1, T n2) {
    const ExactVector i = unit(ExactVector(incident.v)), n = unit(ExactVector(normal.v));
    const Exact eta = Exact(n1) / Exact(n2), cosine = -dot(i, n);
    const ExactVector tangent = i + n * cosine;
    sine = eta * sqrt(dot(tangent, tangent));
    if (sine <= 1) direction = tangent * eta - n * sqrt(1 - sine * sine);
  }
};

template <typename T>
double miss(VectorCena<T> got, const ExactVector& expected) {
  const ExactVector gap = ExactVector(got.v) - expected;
  return static_cast<double>(sqrt(dot(gap, gap)));
}

template <typename T>
class Refraction : public testing::Test {};
using Precisions = testing::Types<float, double, long double>;
TYPED_TEST_SUITE(Refraction, Precisions);

// Within how many roundings of 1 the decision may err: I, N and eta are good to
// one rounding each, and so is the length of the tangent.
constexpr double kSineRoundings = 4;

// At the critical angle +- 10^-k, in a plane of the axes and in any plane: the
// decision is the exact one of the very numbers passed, wherever sin differs
// from 1 by more than its roundings, and for every k that T can tell.
TYPED_TEST(Refraction, CriticalAngleIsDecidedExactly) {
  using T = TypeParam;
  const double epsilon = double(std::numeric_limits<T>::epsilon());
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  int decided = 0, total = 0;
  for (const double index : {1.1, 1.2, 1.33, 1.5, 2.0, 2.42, 3.0, 4.0})
    for (int k = 1; k <= 15; ++k)
      for (const double sign : {-1.0, 1.0})
        for (int turn = 0; turn < 40; ++turn) {
          const double angle = std::asin(1 / index) + sign * std::pow(10.0, -k);
          if (angle >= 1.57) continue;
          glm::dvec3 n(0, 1, 0), along(1, 0, 0);
          if (turn > 0) {
            n = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
            along = glm::normalize(glm::cross(n, {any(random), any(random), any(random)}));
          }
          const VectorCena<T> normal = normalize(VectorCena<T>{glm::vec<3, T>(n)});
          const VectorCena<T> incident = normalize(
              VectorCena<T>{glm::vec<3, T>(std::sin(angle) * along - std::cos(angle) * n)});
          const Snell exact(incident, normal, T(index), T(1));
          VectorCena<T> through;
          const bool passes = refracted(incident, normal, T(index), T(1), through);
          ++total;
          if (abs(exact.sine - 1) <= kSineRoundings * epsilon) continue;
          ++decided;
          ASSERT_EQ(passes, exact.sine < 1)
              << index << " k " << k << " sine - 1 = " << static_cast<double>(exact.sine - 1);
          if (!passes) continue;
          // cos = sqrt(1 - sin^2) magnifies the sine's roundings by tan.
          const double cosine = static_cast<double>(sqrt(1 - exact.sine * exact.sine));
          ASSERT_LE(miss(through, exact.direction), kSineRoundings * epsilon * (1 + 1 / cosine));
          ASSERT_NEAR(double(length(through)), 1, 2 * epsilon);
          VectorCena<T> back;
          ASSERT_TRUE(refracted(-through, -normal, T(1), T(index), back));
          ASSERT_LE(double(length(back + incident)), 8 * epsilon * (1 + index) / std::cos(angle));
        }
  // All but those that T cannot tell from the critical angle.
  EXPECT_GT(decided, total * (sizeof(T) == sizeof(float) ? 3 : 7) / 8);
}

TYPED_TEST(Refraction, ExtremeIndices) {
  using T = TypeParam;
  const double epsilon = double(std::numeric_limits<T>::epsilon());
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> any(-1, 1);
  int passed = 0;
  for (const double n1 : {1e-3, 1.0, 1e3})
    for (const double n2 : {1e-3, 1.0, 1e3})
      for (int n = 0; n < 200; ++n) {
        const auto vector = [&] {
          return normalize(VectorCena<T>{glm::vec<3, T>(any(random), any(random), any(random))});
        };
        const VectorCena<T> normal = vector();
        VectorCena<T> incident = vector();
        if (sir::dot(incident, normal) > 0) incident = -incident;
        if (n % 4 == 0 && n1 > n2)  // steep enough to pass
          incident = normalize(incident * static_cast<T>(0.5 * n2 / n1) - normal);
        const Snell exact(incident, normal, T(n1), T(n2));
        // The tangent of steep rays comes out of a difference of numbers near 1.
        const double ratio = n1 / n2;
        const double error = kSineRoundings * epsilon * (1 + ratio);
        if (abs(exact.sine - 1) <= error) continue;
        VectorCena<T> through;
        const bool passes = refracted(incident, normal, T(n1), T(n2), through);
        ASSERT_EQ(passes, exact.sine < 1) << n1 << " " << n2;
        if (!passes) continue;
        ++passed;
        const double cosine = static_cast<double>(sqrt(1 - exact.sine * exact.sine));
        ASSERT_LE(miss(through, exact.direction), error * (1 + 1 / cosine));
      }
  EXPECT_GT(passed, 900);
}

// A floor y = 0 that is seen at the origin, and one light.
template <typename T>
struct Lit {
  SceneBuilder build;
  RayCounts counts;
  std::vector<glm::dvec3> arriving;

  Lit() {
    build.cube({-8, -1, -8}, {8, 0, 8});
    build.surface(1).first = {{0, 0, 0}, {0.5, 0.5, 0.5}, 0.25, 10, 0, 0};
  }

  double shine(glm::dvec3 light, glm::dvec3 eye = {0, 1, 0}) {
    build.scene.lighting.lights = {{light, glm::dvec3(1)}};
    const Model<T> model(build.finish(0), {});
    Classifier<T> classifier(model.solid);
    const RayCena<T> ray{{glm::vec<3, T>(eye)}, {glm::vec<3, T>(-eye)}};
    classifier.begin(ray);
    Boundary<T> boundary;
    EXPECT_TRUE(classifier.next(boundary));
    counts = {};
    arriving.clear();
    return double(shade(model, classifier, hit_at(model, ray, boundary), counts, &arriving).r);
  }
};

template <typename T>
class Lights : public testing::Test {};
TYPED_TEST_SUITE(Lights, Precisions);

TYPED_TEST(Lights, GrazingByAnyPowerOfTen) {
  using T = TypeParam;
  for (const double distance : {0x1p-10, 1.0, 0x1p10})
    for (int k = 1; k <= 15; ++k) {
      const glm::dvec3 above(3 * distance, std::pow(10.0, -k) * distance, 4 * distance);
      Lit<T> lit;
      // Equation 2.1 of the light's place as T holds it.
      const ExactVector l = unit(ExactVector(glm::vec<3, T>(above)));
      const ExactVector h = unit(l + ExactVector(0, 1, 0));
      const Exact expected = l.y / 2 + pow(h.y, 10) / 4;
      // Handed out as a double.
      const double share = std::max(16 * double(std::numeric_limits<T>::epsilon()), 0x1p-52);
      EXPECT_NEAR(lit.shine(above), static_cast<double>(expected),
                  share * static_cast<double>(expected));
      EXPECT_EQ(lit.counts.shadow, 1u);
      EXPECT_EQ(lit.shine({above.x, -above.y, above.z}), 0) << k;
      EXPECT_EQ(lit.counts.shadow, 0u) << k;
      EXPECT_EQ(lit.arriving.at(0), glm::dvec3(0));
    }
}

TYPED_TEST(Lights, InTheTangentPlaneOrAtThePointDoNothing) {
  Lit<TypeParam> lit;
  for (const auto& light : {glm::dvec3(0), glm::dvec3(3, 0, 4), glm::dvec3(-1e-300, 0, 0),
                            glm::dvec3(8, 0, 8), glm::dvec3(1e15, 0, -1), glm::dvec3(3, -0.0, 4)}) {
    EXPECT_EQ(lit.shine(light), 0) << light.x;
    EXPECT_EQ(lit.counts.shadow, 0u) << light.x;
  }
}

// The floor's shading at a hit put together by hand.
template <typename T>
double shade_by_hand(double exponent, double diffuse, glm::dvec3 light, VectorCena<T> eye,
                     VectorCena<T> normal) {
  SceneBuilder build;
  build.cube({-8, -1, -8}, {8, 0, 8});
  build.surface(1).first = {{0, 0, 0}, glm::dvec3(diffuse), 0.25, exponent, 0, 0};
  build.scene.lighting.lights = {{light, glm::dvec3(1)}};
  EffectSet effects;
  effects.shadow = false;
  const Model<T> model(build.finish(0), effects);
  Classifier<T> classifier(model.solid);
  Hit<T> hit;
  hit.boundary.face = 3;
  hit.boundary.entering = hit.boundary.leaf_entering = true;
  hit.eye = eye;
  hit.incident = -hit.eye;
  hit.normal = normal;
  hit.reflectance = &reflectance_at(model, hit.boundary, hit.point);
  RayCounts counts;
  return double(shade(model, classifier, hit, counts).r);
}

// A highlight is at most Ks, whatever the exponent makes of the roundings of
// N.H. The eye is in the mirrored direction, so that H is N but for roundings.
TYPED_TEST(Lights, HighlightOfAnyExponentIsANumberUpToKs) {
  using T = TypeParam;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const double exponent : {0.0, 1e-6, 1.0, 1e6, 1e9, 1e18, 1e30})
    for (int n = 0; n < 300; ++n) {
      const auto vector = [&] {
        return normalize(VectorCena<T>{glm::vec<3, T>(any(random), any(random), any(random))});
      };
      const VectorCena<T> normal = vector();
      VectorCena<T> light = vector();
      if (sir::dot(normal, light) < 0) light = -light;
      const double got = shade_by_hand<T>(exponent, 0, 4.0 * glm::dvec3(light.v),
                                          mirrored(-light, normal), normal);
      ASSERT_TRUE(got >= 0 && got <= 0.25) << "n = " << exponent << " gives " << got;
      if (exponent <= 1) {
        ASSERT_NEAR(got, 0.25, 1e-6);
      }
    }
}

// As rounding may make them: L + E = 0, E in the surface, E behind it.
TYPED_TEST(Lights, DegenerateEyesGiveNumbers) {
  using T = TypeParam;
  for (const double exponent : {0.0, 1.0, 1e6})
    for (const auto& eye : {glm::dvec3(-0.6, -0.8, 0), glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0),
                            glm::dvec3(-0.6, 0.8, 0)}) {
      const double got =
          shade_by_hand<T>(exponent, 0.5, {3, 4, 0}, {glm::vec<3, T>(eye)}, {{0, 1, 0}});
      const ExactVector half = ExactVector(glm::dvec3(0.6, 0.8, 0)) + ExactVector(eye);
      const double size = std::sqrt(static_cast<double>(dot(half, half)));
      EXPECT_TRUE(got >= 0.399 && got <= 0.6501) << got;
      if (size < 1e-6) continue;  // no direction: zero, or what roundings leave of it
      const double highlight = 0.25 * std::pow(static_cast<double>(half.y) / size, exponent);
      EXPECT_NEAR(got, 0.4 + highlight, 1e-6 * (1 + exponent));
    }
}

TYPED_TEST(Lights, OnASurfaceIsNotHiddenByIt) {
  using T = TypeParam;
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> any(-1, 1);
  int lit_points = 0;
  for (int n = 0; n < 300; ++n) {
    // On the lower side of a ball that hangs above the floor.
    SceneBuilder build;
    const auto floor = build.cube({-8, -1, -8}, {8, 0, 8});
    const glm::dvec3 centre(any(random), 4, any(random));
    const auto ball = build.sphere(centre, 1.5, 2);
    const glm::dvec3 down = glm::normalize(glm::dvec3(any(random), -3, any(random)));
    build.scene.lighting.lights = {{centre + 1.5 * down, glm::dvec3(1)}};
    const Model<T> model(build.finish(build.combine(Operation::union_of, floor, ball)), {});
    Tracer<T> tracer(model, {});
    const glm::dvec3 at(any(random), 0, any(random));
    const RayCena<T> ray{{glm::vec<3, T>(at + glm::dvec3(9, 1, 0))}, {{-9, -1, 0}}};
    // Below the ball's tangent plane in the light: nothing lies between.
    const double facing = glm::dot(down, at - (centre + 1.5 * down));
    ASSERT_GT(facing, 0.1);
    EXPECT_GT(double(tracer.radiance(ray).r), 0.3);
    ++lit_points;
  }
  EXPECT_EQ(lit_points, 300);
}

// A closed room of mirrors seen from inside: each ray adds Ia Ka, so that the
// colour is the sum of ks^d.
enum class Room { cube, ball, cone, cylinder };

template <typename T>
double mirror_room(Room kind, double ks, int depth, Engine engine, glm::dvec3 direction) {
  SceneBuilder build;
  const auto outer = build.cube({-9, -9, -9}, {9, 9, 9});
  const auto cavity =
      kind == Room::cube   ? build.cube({-1, -1, -1}, {1, 1, 1})
      : kind == Room::ball ? build.sphere({0, 0, 0}, 1)
      : kind == Room::cone
          ? build.primitive(PrimitiveKind::cone, test::placed(glm::dvec3(2), {0, -0.5, 0}))
          : build.primitive(PrimitiveKind::cylinder, test::placed(glm::dvec3(2), {0, -1, 0}));
  const auto root = build.combine(Operation::difference, outer, cavity);
  build.surface(1).first = {glm::dvec3(0.5), {0, 0, 0}, ks, 1, 0, 0};
  build.scene.lighting.ambient = glm::dvec3(1);
  build.scene.lighting.background = glm::dvec3(1e6);  // a leak would show
  const Model<T> model(build.finish(root), {});
  TraceOptions options;
  options.depth_limit = depth;
  options.engine = engine;
  Tracer<T> tracer(model, options);
  const T colour =
      tracer.radiance({{{T(0.125), T(0.25), T(-0.0625)}}, {glm::vec<3, T>(direction)}}).g;
  EXPECT_EQ(tracer.counts().reflected, static_cast<std::uint64_t>(depth - 1));
  return double(colour);
}

TYPED_TEST(Lights, MirrorRoomsAddUpTheSeries) {
  using T = TypeParam;
  const double epsilon = double(std::numeric_limits<T>::epsilon());
  for (const Room kind : {Room::cube, Room::ball, Room::cone, Room::cylinder})
    for (const double ks : {1.0, 0.9, 0.5})
      for (const int depth : {1, 2, 100, 2000})
        for (const auto& direction :
             {glm::dvec3(1, 0, 0), glm::dvec3(0.3, -0.2, 0.7), glm::dvec3(1, 1, 1)}) {
          Exact sum = 0, weight = 0.5;
          for (int d = 0; d < depth; ++d, weight *= Exact(T(ks))) sum += weight;
          const double got = mirror_room<T>(kind, ks, depth, Engine::gates, direction);
          // Each of the additions rounds a sum that is at most the last one.
          EXPECT_NEAR(got, static_cast<double>(sum), depth * epsilon * static_cast<double>(sum))
              << "room " << static_cast<int>(kind) << " ks " << ks << " depth " << depth;
          EXPECT_EQ(got, mirror_room<T>(kind, ks, depth, Engine::roth, direction));
        }
}

}  // namespace
}  // namespace sir
