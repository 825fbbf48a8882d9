#include "quant/hue_guard.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "quant/form_sum.h"
#include "quant/grid.h"

namespace sir::quant {
namespace {

constexpr std::size_t kPlanes = 37;

const HsvGrid& grid() {
  static const HsvGrid hsv;
  return hsv;
}

using BestCodes = std::array<std::optional<DacCode>, kPlanes>;

// For each plane, the code of least cost among all that are seen in it.
BestCodes best_codes(const std::array<FormSum, kPlanes>& sums, ColourMeasure& measure,
                     const DacBits& dac) {
  BestCodes best;
  std::array<double, kPlanes> least;
  least.fill(std::numeric_limits<double>::infinity());
  for (int r = 0; r <= dac.max_code(0); ++r)
    for (int g = 0; g <= dac.max_code(1); ++g)
      for (int b = 0; b <= dac.max_code(2); ++b) {
        const DacCode code{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                           static_cast<std::uint8_t>(b)};
        const Rgb8 colour = seen(code, dac);
        const auto plane = static_cast<std::size_t>(hue_plane(colour));
        if (sums[plane].points == 0) continue;
        const double cost = sums[plane].cost(glm::dvec3(measure.point_of(colour)));
        if (cost < least[plane]) {
          least[plane] = cost;
          best[plane] = code;
        }
      }
  return best;
}

}  // namespace

int hue_plane(Rgb8 colour) { return grid().plane(grid().point(grid().cell(colour))); }

void raise_small_hues(std::span<ColourPoint> points) {
  constexpr double kSmall = 0.02, kMost = 2;
  std::array<double, kPlanes> weights{};
  double all = 0;
  std::vector<std::size_t> planes;
  for (const ColourPoint& point : points) {
    const auto byte = [](float mean) { return static_cast<std::uint8_t>(mean + 0.5f); };
    const glm::vec3& mean = point.bytes;
    planes.push_back(
        static_cast<std::size_t>(hue_plane({byte(mean.x), byte(mean.y), byte(mean.z)})));
    weights[planes.back()] += static_cast<double>(point.weight);
    all += static_cast<double>(point.weight);
  }
  std::array<float, kPlanes> factors{};
  for (std::size_t plane = 0; plane < kPlanes; ++plane)
    if (weights[plane] > 0)
      factors[plane] = static_cast<float>(
          std::clamp(std::sqrt(std::sqrt(kSmall * all / weights[plane])), 1.0, kMost));
  for (std::size_t i = 0; i < points.size(); ++i) points[i].weight *= factors[planes[i]];
}

std::vector<int> guard_hues(Palette& palette, std::span<const WeightedColour> colours,
                            ColourMeasure& measure, const DacBits& dac) {
  std::array<FormSum, kPlanes> sums{};
  for (const WeightedColour& one : colours) {
    const auto plane = static_cast<std::size_t>(hue_plane(one.colour));
    sums[plane].add(point_of({&one, 1}, measure));
  }
  std::vector<std::size_t> planes(kPlanes);
  std::iota(planes.begin(), planes.end(), std::size_t{0});
  std::erase_if(planes, [&](std::size_t plane) { return sums[plane].points == 0; });
  std::stable_sort(planes.begin(), planes.end(),
                   [&](auto a, auto b) { return sums[a].weight > sums[b].weight; });

  const auto plane_of_entry = [&](std::size_t entry) {
    return static_cast<std::size_t>(hue_plane(seen(palette.codes()[entry], dac)));
  };
  const auto bind = [&](std::size_t entry, const DacCode& code, std::size_t plane) {
    palette.set(entry, code, {false, [plane, dac](const DacCode& other) {
                                return static_cast<std::size_t>(hue_plane(seen(other, dac))) ==
                                       plane;
                              }});
  };
  // Of the entries that a plane has, the one that serves it best; a pin serves for ever.
  std::vector<std::size_t> without;
  for (const std::size_t plane : planes) {
    std::optional<std::size_t> guard;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < palette.size(); ++i) {
      if (plane_of_entry(i) != plane) continue;
      const bool pinned = palette.rule(i).fixed;
      const double cost =
          pinned ? -1
                 : sums[plane].cost(glm::dvec3(measure.point_of(seen(palette.codes()[i], dac))));
      if (cost < least) {
        least = cost;
        guard = i;
      }
    }
    if (!guard) without.push_back(plane);
    else if (!palette.rule(*guard).fixed) bind(*guard, palette.codes()[*guard], plane);
  }
  if (without.empty()) return {};

  const auto missed = palette.missed();
  std::vector<std::size_t> spare;
  for (std::size_t i = 0; i < palette.size(); ++i)
    if (palette.rule(i).free()) spare.push_back(i);
  std::stable_sort(spare.begin(), spare.end(),
                   [&](auto a, auto b) { return missed[a] < missed[b]; });
  const BestCodes codes = best_codes(sums, measure, dac);
  std::vector<int> lost;
  auto next = spare.begin();
  for (const std::size_t plane : without) {
    if (codes[plane] && next != spare.end()) bind(*next++, *codes[plane], plane);
    else lost.push_back(static_cast<int>(plane));
  }
  palette.assign();
  return lost;
}

}  // namespace sir::quant
