// Scaling by powers of two and mirroring change no digit.
#include "tests/property_tally.h"
#include "tracer/probe.h"

namespace sir {
namespace {

using test::Random;
using test::Regime;
using test::TestRay;

constexpr int kExponents[] = {-40, -20, 20, 40};

// Whether squares of local directions stay within a float's range: a primitive
// of 1e-9 in a scene of 2^-40 has directions of 1e21 in SC_LOCAL.
bool fits(Precision precision, Regime regime, int exponent) {
  return precision == Precision::double_ || std::abs(exponent) <= 20 || regime == Regime::generic ||
         regime == Regime::aligned;
}

glm::dvec3 reflected(glm::dvec3 v, int axis) {
  v[axis] = -v[axis];
  return v;
}

Scene mirrored_scene(Scene scene, int axis) {
  for (CsgNode& node : scene.tree.nodes) {
    for (int column = 0; column < 3; ++column)
      node.placement.linear[column] = reflected(node.placement.linear[column], axis);
    node.placement.translation = reflected(node.placement.translation, axis);
  }
  for (Light& light : scene.lighting.lights) light.position = reflected(light.position, axis);
  CameraFile& camera = scene.camera;
  camera.target = reflected(camera.target, axis);
  camera.normal = reflected(camera.normal, axis);
  camera.up = reflected(camera.up, axis);
  return scene;
}

// SC_CENA stays right-handed: a mirrored scene is seen left to right reversed.
Planes left_to_right(const Planes& image) {
  Planes turned(image.size);
  const auto width = static_cast<std::size_t>(image.size.width);
  for (std::size_t p = 0; p < image.size.pixels(); ++p)
    turned.set(p / width * width + (width - 1 - p % width), image.at(p));
  return turned;
}

class PropertySymmetry : public test::InRegime {
 protected:
  Scene scene(std::uint64_t seed, int most) const {
    Random random(seed);
    test::SceneBuilder build;
    const auto root = test::add_random_solid(build, random, GetParam(), 1 + random.below(most));
    test::light_and_aim(build.scene, random);
    return build.finish(root);
  }
};
SIR_IN_EVERY_REGIME(PropertySymmetry);

std::string difference(const std::vector<ProbeHit>& a, const std::vector<ProbeHit>& b,
                       double scale) {
  if (a.size() != b.size()) return "another number of hits";
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].t * scale != b[i].t) return "another t";
    if (a[i].entering != b[i].entering) return "another side";
    if (a[i].node != b[i].node || a[i].face != b[i].face) return "another name";
  }
  return {};
}

TEST_P(PropertySymmetry, OfHits) {
  test::Tally tally("scaled and mirrored hits", 2.6);
  for (std::uint64_t seed = 1; tally.wants_more(); ++seed) {
    const Scene plain = scene(seed, 20);
    Random random(seed * 80);
    for (const auto precision : {Precision::double_, Precision::float_})
      for (int change = 0; change < 7; ++change) {
        const bool scales = change < 4;
        const double scale = scales ? std::ldexp(1.0, kExponents[change]) : 1;
        const int axis = change - 4;
        if (scales && !fits(precision, GetParam(), kExponents[change])) continue;
        const auto prober = make_prober(plain, precision);
        const auto changed = make_prober(
            scales ? test::moved(plain, scale, {}) : mirrored_scene(plain, axis), precision);
        for (int n = 0; n < 60; ++n) {
          const TestRay ray = test::random_ray(plain, random, GetParam());
          const auto& a = prober->hits(ray.origin, ray.direction);
          const auto& b =
              scales ? changed->hits(scale * ray.origin, ray.direction)
                     : changed->hits(reflected(ray.origin, axis), reflected(ray.direction, axis));
          ++tally.rays;
          tally.hits += a.size();
          const std::string wrong = difference(a, b, scale);
          if (wrong.empty()) continue;
          tally.fail(seed, GetParam(), ray,
                     (scales ? "scaled by 2^" + std::to_string(kExponents[change])
                             : "mirrored in axis " + std::to_string(axis)) +
                         (precision == Precision::float_ ? " in float: " : ": ") + wrong);
        }
      }
    tally.progress();
  }
}

TEST_P(PropertySymmetry, OfImages) {
  test::Tally tally("scaled and mirrored images", 0.4);
  RenderOptions options;
  options.size = {20, 16};
  options.threads = 1;
  for (std::uint64_t seed = 1; tally.wants_more(); ++seed) {
    const Scene plain = scene(seed * 7, 10);
    for (const auto precision : {Precision::double_, Precision::float_}) {
      options.precision = precision;
      const auto image = render(plain, options);
      for (const int exponent : kExponents) {
        if (!fits(precision, GetParam(), exponent)) continue;
        const auto scaled = render(test::moved(plain, std::ldexp(1.0, exponent), {}), options);
        tally.rays += scaled.counts.primary;
        tally.hits += scaled.counts.spans;
        if (scaled.planes != image.planes)
          tally.fail(seed * 7, GetParam(), {}, "another image at 2^" + std::to_string(exponent));
      }
      for (int axis = 0; axis < 3; ++axis) {
        const auto turned = render(mirrored_scene(plain, axis), options);
        tally.rays += turned.counts.primary;
        tally.hits += turned.counts.spans;
        if (left_to_right(turned.planes) != image.planes)
          tally.fail(seed * 7, GetParam(), {}, "another image in mirror " + std::to_string(axis));
      }
    }
    tally.progress();
  }
}

}  // namespace
}  // namespace sir
