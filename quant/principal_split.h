// Splitting colours in two along their principal axis (Wu, Graphics Gems II, 1991; Orchard and
// Bouman 1991), under forms instead of Euclid's distance.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "quant/colour_points.h"
#include "quant/form_sum.h"

namespace sir::quant {

/// Where a group of points is best divided.
struct PrincipalSplit {
  glm::vec3 axis{};  ///< the points with axis . at < threshold go one way
  float threshold = 0;
  double gain = 0;  ///< what two entries cost less than one, none held to a lattice; 0: no split
};

/// The indices of points that make up a group.
using Group = std::span<std::uint32_t>;

FormSum sum_of(std::span<const ColourPoint> points, std::span<const std::uint32_t> group);

/// The axis along which the points spread most, seen through their mean form, and the threshold
/// out of some hundred at most, evenly spaced, that gains most.
PrincipalSplit principal_split(std::span<const ColourPoint> points,
                               std::span<const std::uint32_t> group, const FormSum& sum);

/// Puts those below the threshold first and returns their number; both parts keep their order.
std::size_t divide(std::span<const ColourPoint> points, Group group, const PrincipalSplit& split);

/// All points in groups.
struct Groups {
  std::vector<std::uint16_t> of_point;
  std::vector<FormSum> sums;  ///< by group
};

/// Groups of all points, at most `most`: the group whose split gains most is split next.
Groups split_into(std::span<const ColourPoint> points, std::size_t most);

}  // namespace sir::quant
