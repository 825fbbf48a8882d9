#include "eltek/light_shares.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

namespace sir::eltek {
namespace {

// Beyond so many standard deviations lies a billionth of a spot's light; the outermost source
// pixel that counts gets it.
constexpr double kReach = 6;

// The integral of the spot's distribution function from far left to x; without a spot, of a step.
double ramp(double x, double spot) {
  if (spot <= 0) return std::max(x, 0.0);
  const double t = x / spot;
  const double below = std::erfc(-t / std::numbers::sqrt2) / 2;
  const double density = std::exp(-t * t / 2) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
  return spot * (t * below + density);
}

// What of the light of an output pixel, the stretch from `left` to `right`, comes from source
// places right of x.
double from_right_of(double x, double left, double right, double spot) {
  return (ramp(right - x, spot) - ramp(left - x, spot)) / (right - left);
}

LightShares shares_of(double left, double right, int pixels, double spot) {
  const int first = std::clamp(static_cast<int>(std::floor(left - kReach * spot)), 0, pixels - 1);
  const int end = std::clamp(static_cast<int>(std::ceil(right + kReach * spot)), first + 1, pixels);
  LightShares shares{first, {}};
  // Differences of one falling function from 1 to 0: their sum is 1, whatever is cut off.
  double before = 1;
  for (int next = first + 1; next < end; ++next) {
    const double after = std::min(before, from_right_of(next, left, right, spot));
    shares.weight.push_back(before - after);
    before = after;
  }
  shares.weight.push_back(before);
  return shares;
}

}  // namespace

std::vector<LightShares> light_shares(int pixels, int shown, double spot) {
  if (pixels < 1 || shown < 1) throw std::invalid_argument("a row of light without pixels");
  if (!(spot >= 0)) throw std::invalid_argument("a spot's size is a number >= 0");
  std::vector<LightShares> all;
  all.reserve(static_cast<std::size_t>(shown));
  // Quotients of whole numbers: an edge that is shared is the same to the bit.
  const auto edge = [&](int number) { return static_cast<double>(number) * pixels / shown; };
  for (int i = 0; i < shown; ++i) all.push_back(shares_of(edge(i), edge(i + 1), pixels, spot));
  return all;
}

}  // namespace sir::eltek
