#include "quant/principal_split.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace sir::quant {
namespace {

constexpr std::size_t kMostBins = 128;

// R with R^T R = the mean form: lengths after R are differences under it.
glm::dmat3 whitening(const FormSum& sum) {
  const double xx = sum.xx / sum.weight, yy = sum.yy / sum.weight, zz = sum.zz / sum.weight,
               half = 0.5 * sum.yz / sum.weight;
  const double y = std::sqrt(yy), mixed = half / y;
  glm::dmat3 r(0);
  r[0][0] = std::sqrt(xx);
  r[1][1] = y;
  r[2][1] = mixed;
  r[2][2] = std::sqrt(std::max(zz - mixed * mixed, 0.0));
  return r;
}

glm::dmat3 scatter(std::span<const ColourPoint> points, std::span<const std::uint32_t> group,
                   const glm::dvec3& centre) {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  for (const std::uint32_t i : group) {
    const glm::dvec3 d = glm::dvec3(points[i].at) - centre;
    const double w = points[i].weight;
    xx += w * d.x * d.x;
    yy += w * d.y * d.y;
    zz += w * d.z * d.z;
    xy += w * d.x * d.y;
    xz += w * d.x * d.z;
    yz += w * d.y * d.z;
  }
  return {{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
}

// The eigenvector of the largest eigenvalue, by squaring the matrix: it soon maps all to it.
glm::dvec3 principal_axis(glm::dmat3 matrix) {
  for (int i = 0; i < 12; ++i) {
    const double trace = matrix[0][0] + matrix[1][1] + matrix[2][2];
    if (!(trace > 0)) return {1, 0, 0};
    matrix = matrix * (1 / trace);
    matrix = matrix * matrix;
  }
  const auto longest = std::max({0, 1, 2}, [&](int a, int b) {
    return glm::dot(matrix[a], matrix[a]) < glm::dot(matrix[b], matrix[b]);
  });
  return matrix[longest];
}

}  // namespace

FormSum sum_of(std::span<const ColourPoint> points, std::span<const std::uint32_t> group) {
  FormSum sum;
  for (const std::uint32_t i : group) sum.add(points[i]);
  return sum;
}

PrincipalSplit principal_split(std::span<const ColourPoint> points,
                               std::span<const std::uint32_t> group, const FormSum& sum) {
  PrincipalSplit split;
  if (group.size() < 2) return split;
  const glm::dmat3 white = whitening(sum);
  const glm::dmat3 spread = white * scatter(points, group, sum.best()) * glm::transpose(white);
  split.axis = glm::vec3(glm::transpose(white) * principal_axis(spread));

  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (const std::uint32_t i : group) {
    const float along = glm::dot(split.axis, points[i].at);
    low = std::min(low, along);
    high = std::max(high, along);
  }
  if (!(high > low)) return split;
  const std::size_t count = std::min(group.size(), kMostBins);
  const float scale = static_cast<float>(count) / (high - low);
  std::vector<FormSum> bins(count);
  for (const std::uint32_t i : group) {
    const float along = glm::dot(split.axis, points[i].at);
    bins[std::min(static_cast<std::size_t>((along - low) * scale), count - 1)].add(points[i]);
  }

  // Summed from both ends: a difference of sums would lose the digits of a few light points.
  std::vector<FormSum> above(bins);
  for (std::size_t bin = count - 1; bin-- > 0;) above[bin] += above[bin + 1];
  const double together = sum.least();
  FormSum below;
  for (std::size_t bin = 0; bin + 1 < count; ++bin) {
    if (bins[bin].points == 0) continue;
    below += bins[bin];
    if (above[bin + 1].points == 0) break;
    const double gain = together - below.least() - above[bin + 1].least();
    if (gain > split.gain) {
      split.gain = gain;
      split.threshold = low + static_cast<float>(bin + 1) / scale;
    }
  }
  return split;
}

std::size_t divide(std::span<const ColourPoint> points, Group group, const PrincipalSplit& split) {
  const auto middle = std::stable_partition(group.begin(), group.end(), [&](std::uint32_t i) {
    return glm::dot(split.axis, points[i].at) < split.threshold;
  });
  return static_cast<std::size_t>(middle - group.begin());
}

Groups split_into(std::span<const ColourPoint> points, std::size_t most) {
  struct Box {
    Group group;
    FormSum sum;
    PrincipalSplit split;
  };
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto box_of = [&](Group group) {
    Box box{group, sum_of(points, group), {}};
    box.split = principal_split(points, group, box.sum);
    return box;
  };
  std::vector<Box> boxes{box_of(order)};
  while (boxes.size() < most) {
    const auto next = std::max_element(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) {
      return a.split.gain < b.split.gain;
    });
    if (!(next->split.gain > 0)) break;
    const std::size_t below = divide(points, next->group, next->split);
    if (below == 0 || below == next->group.size()) {  // the threshold's rounding
      next->split.gain = 0;
      continue;
    }
    const Group lower = next->group.first(below), upper = next->group.subspan(below);
    *next = box_of(lower);
    boxes.push_back(box_of(upper));
  }
  Groups groups;
  groups.of_point.resize(points.size());
  for (const Box& box : boxes) {
    for (const std::uint32_t i : box.group)
      groups.of_point[i] = static_cast<std::uint16_t>(groups.sums.size());
    groups.sums.push_back(box.sum);
  }
  return groups;
}

}  // namespace sir::quant
