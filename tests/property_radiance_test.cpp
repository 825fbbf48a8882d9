// Colours are numbers, and bounded.
#include "tests/property_tally.h"
#include "tracer/trace.h"

namespace sir {
namespace {

using test::Random;
using test::Regime;
using test::TestRay;

// What a surface can send back at most by itself, B_1 = sum of Ia Ka and
// If (Kd + Ks), and the largest share of what its secondary rays bring.
struct Bound {
  glm::dvec3 local{0};
  double share = 0;
};

Bound bound_of(const Scene& scene) {
  Bound bound;
  const Lighting& light = scene.lighting;
  const auto take = [&](const Coefficients& k) {
    glm::dvec3 sum = light.ambient * k.ambient;
    for (const Light& source : light.lights) sum += source.intensity * (k.diffuse + k.specular);
    bound.local = glm::max(bound.local, sum);
    bound.share = std::max(bound.share, k.specular + k.transmission);
  };
  for (const Surface& surface : scene.surfaces) {
    take(surface.first);
    if (surface.texture == TextureKind::chequer) take(surface.second);
  }
  return bound;
}

// B_d = max(background, B_1 + (Ks + Kt) B_(d-1)), B_0 = 0.
glm::dvec3 brightest(const Scene& scene, int depth_limit) {
  const Bound bound = bound_of(scene);
  glm::dvec3 b(0);
  for (int depth = 1; depth <= depth_limit; ++depth)
    b = glm::max(scene.lighting.background, bound.local + bound.share * b);
  return b;
}

std::string fault(const glm::dvec3& colour, const glm::dvec3& most) {
  for (int c = 0; c < 3; ++c) {
    if (!std::isfinite(colour[c])) return "no finite colour";
    if (colour[c] < 0) return "a negative colour";
    if (!(colour[c] <= most[c]))
      return std::to_string(colour[c]) + " where " + std::to_string(most[c]) + " is the most";
  }
  return {};
}

class PropertyRadiance : public test::InRegime {
 protected:
  template <typename T>
  void trace(std::uint64_t seed, test::Tally& tally, const TraceOptions& options) const {
    Random random(seed);
    test::SceneBuilder build;
    const auto root = test::add_random_solid(build, random, GetParam(), 1 + random.below(12));
    test::light_and_aim(build.scene, random);
    // A light on a surface or in an edge.
    for (const CsgNode& node : build.scene.tree.nodes)
      if (random.once_in(6)) build.scene.lighting.lights[0].position = node.placement.translation;
    const Scene scene = build.finish(root);
    const Model<T> model(scene, options.allowed_effects);
    Tracer<T> tracer(model, options);
    TraceOptions plainly = options;
    plainly.engine = Engine::roth;
    Tracer<T> plain(model, plainly);
    // A few roundings for each ray that adds to the colour.
    const double roundings = 64 * double(Numeric<T>::kEpsilon);
    const glm::dvec3 most = (1 + roundings) * brightest(scene, options.depth_limit);
    for (int n = 0; n < 100; ++n) {
      const TestRay ray = test::random_ray(scene, random, GetParam());
      const RayCena<T> primary{{glm::vec<3, T>(ray.origin)}, {glm::vec<3, T>(ray.direction)}};
      const glm::dvec3 colour(tracer.radiance(primary));
      std::string wrong = fault(colour, most);
      if (wrong.empty() && n % 8 == 0 && colour != glm::dvec3(plain.radiance(primary)))
        wrong = "another colour by Roth's algorithm";
      if (!wrong.empty())
        tally.fail(seed, GetParam(), ray, (sizeof(T) == sizeof(float) ? "float: " : "") + wrong);
    }
    const RayCounts& counts = tracer.counts();
    tally.rays += counts.primary + counts.reflected + counts.refracted + counts.shadow;
    tally.hits += counts.spans;
  }
};
SIR_IN_EVERY_REGIME(PropertyRadiance);

TEST_P(PropertyRadiance, IsFiniteAndBounded) {
  test::Tally tally("finite, bounded colours", 1.4);
  for (std::uint64_t seed = 1; tally.wants_more(); ++seed) {
    TraceOptions options;
    options.depth_limit = 1 + static_cast<int>(seed % 8);
    options.allowed_effects.exhaustive = seed % 7 == 0;
    trace<double>(seed, tally, options);
    trace<float>(seed, tally, options);
    trace<long double>(seed, tally, options);
    tally.progress();
  }
}

}  // namespace
}  // namespace sir
