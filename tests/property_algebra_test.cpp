// The laws of set algebra, on lists of hits and on images.
#include <functional>

#include "tests/property_tally.h"
#include "tracer/probe.h"

namespace sir {
namespace {

using test::Random;
using test::Regime;
using test::SceneBuilder;
using test::TestRay;
using Id = SceneBuilder::Id;

// Writes expressions over three random solids A, B and C. A solid that stands
// twice is copied with its node numbers, so that surfaces keep their names.
class Term {
 public:
  Term(SceneBuilder& build, const std::array<Id, 3>& solids) : build_(build), solids_(solids) {}
  Id a() { return test::add_copy(build_, solids_[0]); }
  Id b() { return test::add_copy(build_, solids_[1]); }
  Id c() { return test::add_copy(build_, solids_[2]); }
  Id either(Id x, Id y) { return build_.combine(Operation::union_of, x, y); }
  Id both(Id x, Id y) { return build_.combine(Operation::intersection, x, y); }
  Id less(Id x, Id y) { return build_.combine(Operation::difference, x, y); }

 private:
  SceneBuilder& build_;
  const std::array<Id, 3>& solids_;
};

struct Law {
  const char* name;
  /// Whether both sides name coincident surfaces alike. Distribution does not
  /// keep the conditions under which a hidden surface takes part in a boundary.
  bool keeps_names;
  /// Whether a solid stands twice. The copy of a surface that a ray leaves is
  /// recognised within the rounding of the start, and in float that may reach
  /// to the other side of a thin solid.
  bool copies;
  std::function<Id(Term&)> left, right;
};

const std::vector<Law>& laws() {
  static const std::vector<Law> list{
      {"A+B = B+A", true, false, [](Term& t) { return t.either(t.a(), t.b()); },
       [](Term& t) { return t.either(t.b(), t.a()); }},
      {"A&B = B&A", true, false, [](Term& t) { return t.both(t.a(), t.b()); },
       [](Term& t) { return t.both(t.b(), t.a()); }},
      {"(A+B)+C = A+(B+C)", true, false,
       [](Term& t) { return t.either(t.either(t.a(), t.b()), t.c()); },
       [](Term& t) { return t.either(t.a(), t.either(t.b(), t.c())); }},
      {"A-(B+C) = (A-B)-C", true, false,
       [](Term& t) { return t.less(t.a(), t.either(t.b(), t.c())); },
       [](Term& t) { return t.less(t.less(t.a(), t.b()), t.c()); }},
      {"A-(B+C) = (A-B)&(A-C)", true, true,
       [](Term& t) { return t.less(t.a(), t.either(t.b(), t.c())); },
       [](Term& t) { return t.both(t.less(t.a(), t.b()), t.less(t.a(), t.c())); }},
      {"A-(B&C) = (A-B)+(A-C)", false, true,
       [](Term& t) { return t.less(t.a(), t.both(t.b(), t.c())); },
       [](Term& t) { return t.either(t.less(t.a(), t.b()), t.less(t.a(), t.c())); }},
      {"A&(B+C) = (A&B)+(A&C)", false, true,
       [](Term& t) { return t.both(t.a(), t.either(t.b(), t.c())); },
       [](Term& t) { return t.either(t.both(t.a(), t.b()), t.both(t.a(), t.c())); }},
      {"A+(B&C) = (A+B)&(A+C)", false, true,
       [](Term& t) { return t.either(t.a(), t.both(t.b(), t.c())); },
       [](Term& t) { return t.both(t.either(t.a(), t.b()), t.either(t.a(), t.c())); }}};
  return list;
}

std::pair<Scene, Scene> both_sides(const Law& law, std::uint64_t seed, Regime regime, int most) {
  Random random(seed);
  SceneBuilder build;
  std::array<Id, 3> solids{};
  for (Id& solid : solids)
    solid = test::add_random_solid(build, random, regime, 1 + random.below(most));
  Term term(build, solids);
  const Id left = law.left(term), right = law.right(term);
  test::light_and_aim(build.scene, random);
  return {build.finish(left), build.finish(right)};
}

// Where surfaces coincide another of them may name the boundary, with a t that
// differs by the roundings within which it is one event; else all is equal. In
// float surfaces come that near by chance.
bool names_hold(const Law& law, Regime regime, Precision precision) {
  return law.keeps_names || (regime != Regime::aligned && precision == Precision::double_);
}

std::string difference(const std::vector<ProbeHit>& a, const std::vector<ProbeHit>& b, bool names,
                       double epsilon) {
  if (a.size() != b.size()) return "another number of hits";
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].entering != b[i].entering) return "another side";
    if (names ? a[i].t != b[i].t : !(std::abs(a[i].t - b[i].t) <= 128 * epsilon * a[i].t))
      return "another t";
    if (names && (a[i].node != b[i].node || a[i].face != b[i].face || a[i].surface != b[i].surface))
      return "another name";
  }
  return {};
}

class PropertyAlgebra : public test::InRegime {};
SIR_IN_EVERY_REGIME(PropertyAlgebra);

TEST_P(PropertyAlgebra, BothSidesHaveTheSameHits) {
  test::Tally tally("set algebra", 3);
  for (std::uint64_t seed = 1; tally.wants_more(); ++seed) {
    for (const Law& law : laws()) {
      const auto [left, right] = both_sides(law, seed, GetParam(), 5);
      Random random(seed * 79);
      for (const auto precision : {Precision::double_, Precision::float_}) {
        const bool names = names_hold(law, GetParam(), precision);
        const double epsilon = precision == Precision::float_ ? 0x1p-23 : 0x1p-52;
        const auto one = make_prober(left, precision), other = make_prober(right, precision);
        for (int n = 0; n < 200; ++n) {
          const TestRay ray = test::random_ray(left, random, GetParam());
          const auto& a = one->hits(ray.origin, ray.direction);
          const auto& b = other->hits(ray.origin, ray.direction);
          ++tally.rays;
          tally.hits += a.size();
          const std::string wrong = difference(a, b, names, epsilon);
          if (!wrong.empty())
            tally.fail(seed, GetParam(), ray, std::string(law.name) + ": " + wrong);
        }
      }
    }
    tally.progress();
  }
}

TEST_P(PropertyAlgebra, BothSidesGiveTheSameImage) {
  test::Tally tally("set algebra in images", 0.4);
  RenderOptions options;
  options.size = {20, 15};
  options.threads = 1;
  for (std::uint64_t seed = 1; tally.wants_more(); ++seed) {
    for (const Law& law : laws()) {
      const bool stout = GetParam() == Regime::generic || GetParam() == Regime::aligned;
      const auto [left, right] = both_sides(law, seed * 5, GetParam(), 4);
      for (const auto precision : {Precision::double_, Precision::float_}) {
        if (!names_hold(law, GetParam(), precision)) continue;
        if (law.copies && !stout && precision == Precision::float_) continue;
        options.precision = precision;
        const auto one = render(left, options), other = render(right, options);
        tally.rays += one.counts.primary;
        tally.hits += one.counts.spans;
        if (one.planes != other.planes)
          tally.fail(seed * 5, GetParam(), {}, std::string(law.name) + ": another image");
      }
    }
    tally.progress();
  }
}

}  // namespace
}  // namespace sir
