// Lists of hits of random solids: order, sides, engines, and what lies between.
#include "tests/property_membership.h"
#include "tests/property_tally.h"
#include "tracer/probe.h"

namespace sir {
namespace {

using test::Membership;
using test::Random;
using test::Side;
using test::TestRay;

constexpr int kRaysPerSolid = 500;

double largest(const glm::dvec3& v) {
  return glm::max(glm::abs(v.x), glm::max(glm::abs(v.y), glm::abs(v.z)));
}

class PropertyHits : public test::InRegime {
 protected:
  Scene scene(std::uint64_t seed, int most) const {
    Random random(seed);
    test::SceneBuilder build;
    return build.finish(test::add_random_solid(build, random, GetParam(), 1 + random.below(most)));
  }
};
SIR_IN_EVERY_REGIME(PropertyHits);

bool same(const ProbeHit& a, const ProbeHit& b) {
  return a.t == b.t && a.entering == b.entering && a.node == b.node && a.face == b.face &&
         a.surface == b.surface;
}

// Entering and leaving alternate, t ascends from 0 and is finite, and the ray
// ends outside.
std::string disorder(const std::vector<ProbeHit>& hits) {
  double last = -1;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!std::isfinite(hits[i].t) || hits[i].t < 0) return "t is no place on the ray";
    if (!(hits[i].t > last)) return "t does not ascend";
    if (i > 0 && hits[i].entering == hits[i - 1].entering) return "sides do not alternate";
    last = hits[i].t;
  }
  if (!hits.empty() && hits.back().entering) return "the ray never leaves";
  return {};
}

// The list against exact membership at the origin, between hits, and anywhere.
class Between {
 public:
  Between(const Membership& membership, test::Tally& tally, double epsilon)
      : membership_(membership), tally_(tally), epsilon_(epsilon) {}

  std::string compare(const TestRay& ray, const std::vector<ProbeHit>& hits, double anywhere) {
    const bool starts_inside = !hits.empty() && !hits.front().entering;
    if (wrong(ray, 0, starts_inside)) return "the origin is on the other side";
    double from = 0;
    for (const ProbeHit& hit : hits) {
      if (wrong(ray, from / 2 + hit.t / 2, !hit.entering))
        return "wrong side before t = " + std::to_string(hit.t);
      from = hit.t;
    }
    bool inside = starts_inside;
    for (const ProbeHit& hit : hits)
      if (hit.t < anywhere) inside = hit.entering;
    if (wrong(ray, anywhere, inside)) return "wrong side at t = " + std::to_string(anywhere);
    return {};
  }

 private:
  bool wrong(const TestRay& ray, double t, bool inside) {
    const double extent = largest(ray.origin) + t * largest(ray.direction);
    const Side side = membership_.of(ray.origin + t * ray.direction, extent, epsilon_);
    ++(side == Side::undecided ? tally_.undecided : tally_.decided);
    return side != Side::undecided && (side == Side::inside) != inside;
  }

  const Membership& membership_;
  test::Tally& tally_;
  double epsilon_;
};

TEST_P(PropertyHits, AlternateAndAgreeWithExactMembership) {
  test::Tally tally("order and membership", 8);
  for (std::uint64_t seed = 1; tally.wants_more(); ++seed) {
    const Scene made = scene(seed, 30);
    const Membership membership(made);
    Random random(seed * 77);
    for (const auto precision : {Precision::double_, Precision::float_}) {
      const bool is_float = precision == Precision::float_;
      const auto prober = make_prober(made, precision);
      Between between(membership, tally, is_float ? 0x1p-23 : 0x1p-52);
      for (int n = 0; n < kRaysPerSolid / (is_float ? 4 : 1); ++n) {
        const TestRay ray = test::random_ray(made, random, GetParam());
        const auto& hits = prober->hits(ray.origin, ray.direction);
        ++tally.rays;
        tally.hits += hits.size();
        std::string wrong = disorder(hits);
        if (wrong.empty()) wrong = between.compare(ray, hits, random.between(0, 2));
        if (!wrong.empty()) tally.fail(seed, GetParam(), ray, (is_float ? "float, " : "") + wrong);
      }
    }
    tally.progress();
  }
}

TEST_P(PropertyHits, EnginesAgree) {
  test::Tally tally("engines", 3);
  for (std::uint64_t seed = 1; tally.wants_more(); ++seed) {
    const Scene made = scene(seed * 3, 30);
    Random random(seed * 78);
    for (const auto precision : {Precision::double_, Precision::float_}) {
      const auto gates = make_prober(made, precision, Engine::gates);
      const auto roth = make_prober(made, precision, Engine::roth);
      for (int n = 0; n < kRaysPerSolid; ++n) {
        const TestRay ray = test::random_ray(made, random, GetParam());
        const auto& a = gates->hits(ray.origin, ray.direction);
        const auto& b = roth->hits(ray.origin, ray.direction);
        ++tally.rays;
        tally.hits += a.size();
        if (!std::equal(a.begin(), a.end(), b.begin(), b.end(), same))
          tally.fail(seed * 3, GetParam(), ray,
                     precision == Precision::float_ ? "engines differ in float" : "engines differ");
      }
    }
    tally.progress();
  }
}

}  // namespace
}  // namespace sir
