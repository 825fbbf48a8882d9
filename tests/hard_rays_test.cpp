// Every hard ray against its exact answer: hard cases stay numerically stable.
//
// Double, both engines: wherever the answer is definite (no gap between events
// within 28 to 36 ulp) the list of (node, face, side) is the exact one, and every
// t has a relative error of at most 1e-12, or else a backward error of at most 8
// roundings of each input and a relative error of at most 1e-9.
//
// Float has a domain (in_float_domain): every primitive of condition at most 1e4,
// eye and origin within 1e3 of its sizes, sizes within a factor of 1e3; so of the
// classes all that put solids together, edges, corners, parallels, coincidence,
// starts, chains and random trees, and of the others the near part: quadratic_far
// and _huge to 1e3, grazing to about 1e-3, aniso, shear and condition to 1e4,
// translated to 1e3. Rays are the nearest in float, the scene is the file's in
// double. There the list must be the exact one by the rule of 32 ulp of float, and
// t right within 1e-4 of the larger of t and the solids' size, unless 16 roundings
// to float of every input could change the list. Scenes and rays in multiples of
// 1/64 up to 64 are the same in float and have no such excuse.
//
// Long double, both engines: as double; where it is wider no excuse is needed, t is
// within a unit in the last place of double, of which half is its rounding to one.
//
// The table's columns. rays: of the class; cross: those that meet the solid. Double,
// float, long double: sure: definite answers (float: in the domain); list: the same list;
// right: and every t; t error: worst among the right ones, relative (float: to the
// larger of t and size); rounds: worst backward error of t, in roundings; all: rays
// of the whole class that float gets right, in the domain or not.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <map>

#include "tests/hard_rays_check.h"
#include "tracer/numeric.h"

namespace sir::test {
namespace {

// What is measured for one class in one precision.
struct Score {
  int rays = 0, crossing = 0, definite = 0, same_list = 0, right = 0, right_in_all = 0;
  double relative_error = 0, backward = 0;

  void add(const Verdict& verdict, bool crosses, bool in_domain, bool is_definite) {
    ++rays;
    crossing += crosses;
    right_in_all += verdict.right;
    if (!in_domain || !is_definite) return;
    ++definite;
    same_list += verdict.same_list;
    right += verdict.right;
    if (!verdict.right) return;
    relative_error = std::max(relative_error, verdict.relative_error);
    backward = std::max(backward, verdict.backward_roundings);
  }
};

// What a long double's t may be off by, handed out as a double: each is known to
// Numeric::kTrustedRoundings.
constexpr double kLongRelativeError = kWiderThanDouble<long double> ? 0x1p-52 : kRelativeErrorAtAll;

using Scores = std::array<Score, 3>;  // double, float, long double

// The table at the end of the program, of the classes that ran.
class Table : public testing::Environment {
 public:
  void TearDown() override {
    if (rows().empty()) return;
    std::printf("%-24s %5s %5s | %5s %5s %5s %8s %6s | %5s %5s %5s %8s %5s | %5s %5s %5s %8s\n",
                "class", "rays", "cross", "sure", "list", "right", "t error", "rounds", "sure",
                "list", "right", "t error", "all", "sure", "list", "right", "t error");
    Scores sum;
    for (const HardClass& each : hard_classes()) {
      const auto row = rows().find(each.name);
      if (row == rows().end()) continue;
      print(each.name, row->second);
      for (std::size_t i = 0; i < sum.size(); ++i) total(sum[i], row->second[i]);
    }
    print("all", sum);
  }

  static std::map<std::string, Scores>& rows() {
    static std::map<std::string, Scores> all;
    return all;
  }

 private:
  static void print(const std::string& name, const Scores& scores) {
    const auto& [d, f, l] = scores;
    std::printf(
        "%-24s %5d %5d | %5d %5d %5d %8.1e %6.2f | %5d %5d %5d %8.1e %5d | "
        "%5d %5d %5d %8.1e\n",
        name.c_str(), d.rays, d.crossing, d.definite, d.same_list, d.right, d.relative_error,
        d.backward, f.definite, f.same_list, f.right, f.relative_error, f.right_in_all, l.definite,
        l.same_list, l.right, l.relative_error);
  }
  static void total(Score& sum, const Score& part) {
    sum.rays += part.rays;
    sum.crossing += part.crossing;
    sum.definite += part.definite;
    sum.same_list += part.same_list;
    sum.right += part.right;
    sum.right_in_all += part.right_in_all;
    sum.relative_error = std::max(sum.relative_error, part.relative_error);
    sum.backward = std::max(sum.backward, part.backward);
  }
};
const auto* const kTable = testing::AddGlobalTestEnvironment(new Table);

// Failures of one class: the first few in full, the rest counted.
class Failures {
 public:
  explicit Failures(const HardClass& of) : of_(of) {}
  void add(const std::string& in, std::size_t index, const std::string& reason,
           const std::string& description) {
    if (count_++ < 3)
      text_ += "\n" + of_.name + " #" + std::to_string(index) + " seed " +
               std::to_string(of_.seed()) + " " + in + ": " + reason + "\n  " + description;
  }
  void report() const {
    if (count_ > 0) ADD_FAILURE() << of_.name << ": " << count_ << " wrong; the first:" << text_;
  }

 private:
  const HardClass& of_;
  int count_ = 0;
  std::string text_;
};

// The oracle against itself: the sweep agrees with single points, and the double
// nearest to each t lies on the face that is named, but for its own rounding.
std::string contradiction_in(const ExactOracle& oracle, const HardRay& ray,
                             const ExactAnswer& exact) {
  for (const ExactHit& hit : exact.hits)
    if (hit.own_face && oracle.backward_error(hit.node_index, hit.face, ray.origin, ray.direction,
                                              hit.t.convert_to<double>())
                                .roundings > 1.5)
      return "t is not on the named face";
  for (const int digits : {53, 24}) {
    const std::string text = oracle.disagreement(ray.origin, ray.direction, digits);
    if (!text.empty()) return text;
  }
  return {};
}

class HardRays : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Class, HardRays, testing::Range<std::size_t>(0, hard_classes().size()),
                         [](const auto& one) { return hard_classes()[one.param].name; });

TEST_P(HardRays, HaveTheExactAnswer) {
  const HardClass& of = hard_classes()[GetParam()];
  const std::vector<HardRay> rays = of.rays();
  ASSERT_GE(rays.size(), 60u);
  Failures in_double(of), in_float_failures(of), in_long_double(of), in_oracle(of);
  Score double_score, float_score, long_score;

  std::unique_ptr<ExactOracle> oracle;
  std::unique_ptr<Prober> gates, roth, single_gates, single_roth, long_gates, long_roth;
  const Scene* current = nullptr;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const HardRay& ray = rays[i];
    if (ray.scene.get() != current) {
      current = ray.scene.get();
      oracle = std::make_unique<ExactOracle>(*current);
      gates = make_prober(*current, Precision::double_, Engine::gates);
      roth = make_prober(*current, Precision::double_, Engine::roth);
      long_gates = make_prober(*current, Precision::long_double, Engine::gates);
      long_roth = make_prober(*current, Precision::long_double, Engine::roth);
      single_gates = make_prober(*current, Precision::float_, Engine::gates);
      single_roth = make_prober(*current, Precision::float_, Engine::roth);
    }

    const ExactAnswer exact = oracle->answer(ray.origin, ray.direction);
    const std::string contradiction = contradiction_in(*oracle, ray, exact);
    if (!contradiction.empty()) in_oracle.add("oracle", i, contradiction, describe(ray, exact, {}));
    Verdict worst;
    for (const auto& [name, prober] : {std::pair{"gates", gates.get()}, {"roth", roth.get()}}) {
      const auto& found = prober->hits(ray.origin, ray.direction);
      const Verdict verdict = judge_double(*oracle, ray, exact, found);
      if (exact.definite && !verdict.right)
        in_double.add(std::string("double ") + name, i, verdict.reason,
                      describe(ray, exact, found));
      if (name == std::string("gates") || !verdict.right) worst = verdict;
    }
    double_score.add(worst, !exact.hits.empty(), true, exact.definite);

    for (const auto& [name, prober] :
         {std::pair{"gates", long_gates.get()}, {"roth", long_roth.get()}}) {
      const auto& found = prober->hits(ray.origin, ray.direction);
      Verdict verdict = judge_double(*oracle, ray, exact, found);
      if (verdict.right && !(verdict.relative_error <= kLongRelativeError)) {
        verdict.right = false;
        verdict.reason = "t is off by " + std::to_string(verdict.relative_error / 0x1p-53) +
                         " roundings of double";
      }
      if (exact.definite && !verdict.right)
        in_long_double.add(std::string("long double ") + name, i, verdict.reason,
                           describe(ray, exact, found));
      if (name == std::string("gates") || !verdict.right) worst = verdict;
    }
    long_score.add(worst, !exact.hits.empty(), true, exact.definite);

    const HardRay narrow = in_float(ray);
    const bool in_domain = in_float_domain(narrow);
    const double size = seen_size(narrow);
    ExactAnswer narrow_exact =
        oracle->answer(narrow.origin, narrow.direction, float_allowance(narrow));
    narrow_exact.definite = narrow_exact.definite && times_fit_float(narrow_exact, size);
    for (const auto& [name, prober] :
         {std::pair{"gates", single_gates.get()}, {"roth", single_roth.get()}}) {
      const auto& found = prober->hits(narrow.origin, narrow.direction);
      const Verdict verdict = judge_float(narrow_exact, found, size);
      if (in_domain && narrow_exact.definite && !verdict.right)
        in_float_failures.add(std::string("float ") + name, i, verdict.reason,
                              describe(narrow, narrow_exact, found));
      if (name == std::string("gates") || !verdict.right) worst = verdict;
    }
    float_score.add(worst, !narrow_exact.hits.empty(), in_domain, narrow_exact.definite);
  }
  // A class of which nothing is definite would prove nothing.
  EXPECT_GE(double_score.definite, static_cast<int>(rays.size()) * 9 / 10);
  Table::rows()[of.name] = {double_score, float_score, long_score};
  in_oracle.report();
  in_double.report();
  in_float_failures.report();
  in_long_double.report();
}

TEST(HardRayList, IsLongAndTheSameEveryTime) {
  std::size_t count = 0;
  for (const HardClass& each : hard_classes()) {
    const auto once = each.rays(), again = each.rays();
    count += once.size();
    for (std::size_t i = 0; i < once.size(); ++i) {
      ASSERT_EQ(once[i].origin, again[i].origin);
      ASSERT_EQ(once[i].direction, again[i].direction);
      ASSERT_NE(once[i].direction, glm::dvec3(0)) << each.name << ' ' << i;
    }
  }
  EXPECT_GE(count, 2500u);
}

}  // namespace
}  // namespace sir::test
