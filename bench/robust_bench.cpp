// What does it cost to be sure? Times the textbook's intersection, ours with its
// bounds, and ours with its doubts settled exactly, on the same rays in one run;
// and counts what each gets wrong. Usage: robust_bench
// Runs are interleaved on one thread; medians of the ratios are printed.
#include <cstdio>
#include <random>
#include <vector>

#include "bench/timing.h"
#include "tracer/intersect_exact.h"
#include "tracer/intersect_textbook.h"
#include "tracer/solid.h"

namespace {

using namespace sir;
using bench::median;

constexpr int kRays = 100'000;
const int kRounds = sir::bench::rounds(15);
constexpr const char* kNames[] = {"cube", "sphere", "cone", "cylinder"};

Placement turned(std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  const glm::dvec3 a = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
  const glm::dvec3 b = glm::normalize(glm::cross(a, glm::dvec3(any(random), 1, any(random))));
  Placement placement;
  placement.linear = glm::dmat3(a * 1.5, b * 0.75, glm::cross(a, b) * 1.25);
  placement.translation = {any(random), any(random), any(random)};
  return placement;
}

// Rays of length 1 towards the solid and its surroundings, from `distance` sizes
// away; half of them hit.
template <typename T>
std::vector<RayCena<T>> rays_at(const Placement& placement, double distance,
                                std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<RayCena<T>> rays;
  for (int i = 0; i < kRays; ++i) {
    const glm::dvec3 target = placement.linear * glm::dvec3(any(random), any(random), any(random)) +
                              placement.translation;
    const glm::dvec3 way = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
    rays.push_back({{glm::vec<3, T>(target - distance * way)}, {glm::vec<3, T>(way)}});
  }
  return rays;
}

// Right: hit or miss as in exact arithmetic, and both ends within 1e-12 (float:
// 1e-4) of t.
template <typename T>
bool right(bool hit, T enter, T leave, bool exact_hit, const Span<T>& exact) {
  if (hit != exact_hit) return false;
  const T limit = sizeof(T) == 4 ? T(1e-4f) : T(1e-12);
  return !hit || (std::abs(enter - exact.enter) <= limit * std::abs(exact.enter) &&
                  std::abs(leave - exact.leave) <= limit * std::abs(exact.leave));
}

template <typename T>
void measure(const char* scalar, PrimitiveKind kind, double distance, bool with_times) {
  std::mt19937_64 random(5);
  CsgNode node;
  node.kind = kind;
  node.placement = turned(random);
  Scene scene;
  scene.tree.nodes = {node};
  scene.surfaces.resize(1);
  const Solid<T> solid = build_solid<T>(scene);
  const TextbookLeaf<T> textbook(kind, node.placement);
  const auto rays = rays_at<T>(node.placement, distance, random);
  const Leaf<T>& leaf = solid.leaves[0];

  T sink = 0;
  const auto plain = [&](const RayCena<T>& ray, Span<T>& span) {
    return intersect_as_in_textbooks(textbook, ray, span);
  };
  const auto bounded = [&](const RayCena<T>& ray, Span<T>& span) {
    return intersect(kind, leaf.to_local(ray, T(1)), span);
  };
  const auto sure = [&](const RayCena<T>& ray, Span<T>& span) {
    const Crossing crossing = bounded(ray, span);
    constexpr T kTrust = Numeric<T>::kTrustedRoundings * Numeric<T>::kEpsilon;
    if (crossing == Crossing::crosses && span.enter_error <= kTrust * std::abs(span.enter) &&
        span.leave_error <= kTrust * std::abs(span.leave))
      return true;
    if (crossing == Crossing::misses) return false;
    return intersect_exactly(kind, node.placement, ray, T(0), span);
  };

  int wrong_plain = 0, wrong_sure = 0, settled = 0;
  for (const auto& ray : rays) {
    Span<T> exact{}, said{}, span{};
    const bool hit = intersect_exactly(kind, node.placement, ray, T(0), exact);
    const bool says = plain(ray, said);
    wrong_plain += !right(says, said.enter, said.leave, hit, exact);
    const bool found = sure(ray, span);
    settled += found && span.enter_error == 0;
    wrong_sure += !right(found, span.enter, span.leave, hit, exact);
  }
  std::printf("%-6s %-8s %7.0e  textbook wrong %6.3f %%, sure wrong %6.3f %%, settled %6.3f %%",
              scalar, kNames[static_cast<int>(kind)], distance, 100.0 * wrong_plain / kRays,
              100.0 * wrong_sure / kRays, 100.0 * settled / kRays);
  if (with_times) {
    std::vector<double> plain_ns, bounded_ratio, sure_ratio;
    for (int round = 0; round < kRounds; ++round) {
      const double a = bench::milliseconds([&] {
        Span<T> span;
        for (const auto& ray : rays) sink += plain(ray, span) ? span.enter : T(0);
      });
      const double b = bench::milliseconds([&] {
        Span<T> span;
        for (const auto& ray : rays)
          sink += bounded(ray, span) == Crossing::crosses ? span.enter : T(0);
      });
      const double c = bench::milliseconds([&] {
        Span<T> span;
        for (const auto& ray : rays) sink += sure(ray, span) ? span.enter : T(0);
      });
      plain_ns.push_back(a * 1e6 / kRays);
      bounded_ratio.push_back(b / a);
      sure_ratio.push_back(c / a);
    }
    std::printf("; textbook %5.1f ns, bounded x%.2f, sure x%.2f", median(plain_ns),
                median(bounded_ratio), median(sure_ratio));
  }
  std::printf("%s\n", std::isnan(sink) ? "!" : "");
}

}  // namespace

int main() {
  for (int k = 0; k < 4; ++k) {
    const auto kind = static_cast<PrimitiveKind>(k);
    measure<double>("double", kind, 5, true);
    measure<float>("float", kind, 5, true);
  }
  for (int k = 0; k < 4; ++k)
    for (const double distance : {1e2, 1e4, 1e6, 1e8})
      measure<double>("double", static_cast<PrimitiveKind>(k), distance, distance == 1e4);
}
