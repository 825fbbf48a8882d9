#include "tests/hard_rays_check.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <glm/geometric.hpp>

namespace sir::test {
namespace {

bool same_list(const ExactAnswer& exact, const std::vector<ProbeHit>& found) {
  return std::equal(exact.hits.begin(), exact.hits.end(), found.begin(), found.end(),
                    [](const ExactHit& a, const ProbeHit& b) {
                      return a.node == b.node && a.face == b.face && a.entering == b.entering;
                    });
}

// Size of a matrix: root mean square of its columns' lengths.
double size_of(const glm::dmat3& m) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += glm::dot(m[i], m[i]);
  return std::sqrt(sum / 3);
}

bool short_number(double x) { return std::abs(x) <= 64 && x * 64 == std::floor(x * 64); }

bool short_vector(const glm::dvec3& v) {
  return short_number(v.x) && short_number(v.y) && short_number(v.z);
}

double near_one(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return std::ldexp(1.0, -std::ilogb(largest));
}

void write(std::ostream& out, const glm::dvec3& v) { out << v.x << ' ' << v.y << ' ' << v.z; }

}  // namespace

Verdict judge_double(const ExactOracle& oracle, const HardRay& ray, const ExactAnswer& exact,
                     const std::vector<ProbeHit>& found) {
  Verdict verdict;
  if (!same_list(exact, found)) {
    verdict.reason = "the lists differ";
    return verdict;
  }
  verdict.same_list = verdict.right = true;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const ExactHit& hit = exact.hits[i];
    const double t = found[i].t;
    if (!std::isfinite(t)) {
      verdict.right = false;
      verdict.reason = "t is not finite";
      return verdict;
    }
    if (hit.t == 0) {
      if (t == 0) continue;
      verdict.right = false;
      verdict.reason = "t must be 0";
      return verdict;
    }
    const double relative = Real(abs(Real(t) - hit.t) / hit.t).convert_to<double>();
    const auto backward =
        oracle.backward_error(hit.node_index, hit.face, ray.origin, ray.direction, t);
    // Nearer to the start than a rounding of the inputs reaches: no digit of t
    // is defined by them.
    const bool lost = abs(hit.t) < backward.one_rounding;
    if (hit.own_face)
      verdict.backward_roundings = std::max(verdict.backward_roundings, backward.roundings);
    if (!lost) verdict.relative_error = std::max(verdict.relative_error, relative);
    if (relative <= kRelativeError) continue;
    if (backward.roundings <= kBackwardRoundings && (relative <= kRelativeErrorAtAll || lost))
      continue;
    std::ostringstream text;
    text << "t of hit " << i << " is off by " << relative << ", " << backward.roundings
         << " roundings";
    verdict.reason = text.str();
    verdict.right = false;
  }
  return verdict;
}

Verdict judge_float(const ExactAnswer& exact, const std::vector<ProbeHit>& found, double size) {
  Verdict verdict;
  if (!same_list(exact, found)) {
    verdict.reason = "the lists differ";
    return verdict;
  }
  verdict.same_list = verdict.right = true;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double t = exact.hits[i].t.convert_to<double>();
    const double error = std::abs(found[i].t - t) / std::max(std::abs(t), size);
    verdict.relative_error = std::max(verdict.relative_error, error);
    if (error <= kFloatError) continue;  // false for a NaN
    verdict.right = false;
    std::ostringstream text;
    text << "t of hit " << i << " is off by " << error;
    verdict.reason = text.str();
  }
  return verdict;
}

HardRay in_float(const HardRay& ray) {
  HardRay result = ray;
  const double factor = near_one(ray.direction);
  for (int i = 0; i < 3; ++i) {
    result.origin[i] = double(static_cast<float>(ray.origin[i]));
    result.direction[i] = double(static_cast<float>(ray.direction[i] * factor)) / factor;
  }
  return result;
}

bool in_float_domain(const HardRay& ray) {
  constexpr double kSizes = 1e3, kCondition = 1e4;
  double smallest = HUGE_VAL, largest = 0;
  for (const CsgNode& node : ray.scene->tree.nodes) {
    if (node.composite) continue;
    const glm::dmat3& m = node.placement.linear;
    const double size = size_of(m);
    const double condition = 3 * size * size_of(glm::inverse(m / size)) / size;
    if (!(condition <= kCondition)) return false;
    if (glm::length(ray.origin - node.placement.translation) > kSizes * size) return false;
    if (glm::length(node.placement.translation) > kSizes * size) return false;
    smallest = std::min(smallest, size);
    largest = std::max(largest, size);
  }
  return largest <= kSizes * smallest;
}

Allowance float_allowance(const HardRay& ray) {
  bool all_short = short_vector(ray.origin) && short_vector(ray.direction);
  for (const CsgNode& node : ray.scene->tree.nodes) {
    if (node.composite) continue;
    all_short = all_short && short_vector(node.placement.translation);
    for (int i = 0; i < 3; ++i) all_short = all_short && short_vector(node.placement.linear[i]);
  }
  return {24, all_short ? 0 : kFloatRoundings};
}

double seen_size(const HardRay& ray) {
  double largest = 0;
  for (const CsgNode& node : ray.scene->tree.nodes)
    if (!node.composite) largest = std::max(largest, size_of(node.placement.linear));
  const double factor = near_one(ray.direction);
  return largest / glm::length(ray.direction * factor) * factor;
}

bool times_fit_float(const ExactAnswer& exact, double size) {
  return std::all_of(exact.hits.begin(), exact.hits.end(), [&](const ExactHit& hit) {
    return hit.slack <= 0.5 * kFloatError * (std::max)(Real(hit.t), Real(size));
  });
}

std::string describe(const HardRay& ray, const ExactAnswer& exact,
                     const std::vector<ProbeHit>& found) {
  constexpr const char* kKindNames[] = {"cube", "sphere", "cone", "cylinder"};
  constexpr const char* kOperationNames[] = {"union", "difference", "intersection"};
  std::ostringstream text;
  text.precision(17);
  text << "ray ";
  write(text, ray.origin);
  text << "  ";
  write(text, ray.direction);
  const auto& nodes = ray.scene->tree.nodes;
  if (nodes.size() <= 9) {
    for (const CsgNode& node : nodes) {
      text << "\n  node " << node.number;
      if (node.composite) {
        text << ": " << kOperationNames[static_cast<int>(node.operation)] << " of "
             << nodes[node.left].number << ' ' << nodes[node.right].number;
        continue;
      }
      text << ": " << kKindNames[static_cast<int>(node.kind)];
      for (int i = 0; i < 3; ++i) {
        text << " / ";
        write(text, node.placement.linear[i]);
      }
      text << " / ";
      write(text, node.placement.translation);
    }
  }
  const auto boundary = [&](bool entering, std::int64_t node, int face) {
    text << (entering ? " in  " : " out ") << "node " << node << " face " << face;
  };
  for (const ExactHit& hit : exact.hits) {
    text << "\n  exact ";
    boundary(hit.entering, hit.node, hit.face);
    text << " t " << hit.t.convert_to<double>();
  }
  for (const ProbeHit& hit : found) {
    text << "\n  found ";
    boundary(hit.entering, hit.node, hit.face);
    text << " t " << hit.t;
  }
  return text.str();
}

}  // namespace sir::test
