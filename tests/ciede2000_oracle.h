// CIEDE2000 once more, from the paper, in long double.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "quant/ciede2000.h"

namespace sir::test {

/// The square of CIEDE2000 with all weights 1, by equations 2 to 22 of Sharma, Wu and Dalal 2005.
/// Its arguments are long double since a difference of 1e-3 squared is to be right to nine digits.
struct WideLab {
  long double l = 0, a = 0, b = 0;
};

inline long double ciede2000_squared(const WideLab& first, const WideLab& second) {
  using std::cos, std::exp, std::hypot, std::pow, std::sin, std::sqrt;
  constexpr long double kPi = std::numbers::pi_v<long double>;
  const auto radians = [](long double degrees) { return degrees * kPi / 180; };
  const long double mean_ab = (hypot(first.a, first.b) + hypot(second.a, second.b)) / 2;
  const auto saturating = [](long double c) {
    const long double c7 = pow(c, 7.0L);
    return sqrt(c7 / (c7 + 6103515625.0L));  // 25^7
  };
  const long double g = (1 - saturating(mean_ab)) / 2;
  const long double a1 = (1 + g) * first.a, a2 = (1 + g) * second.a;
  const long double c1 = hypot(a1, first.b), c2 = hypot(a2, second.b);
  const auto hue = [&](long double a, long double b) {
    if (a == 0 && b == 0) return 0.0L;
    const long double degrees = std::atan2(b, a) * 180 / kPi;
    return degrees < 0 ? degrees + 360 : degrees;
  };
  const long double h1 = hue(a1, first.b), h2 = hue(a2, second.b);
  long double turn = 0, mean_h = h1 + h2;
  if (c1 * c2 != 0) {
    turn = h2 - h1;
    if (turn > 180) turn -= 360;
    if (turn < -180) turn += 360;
    if (std::abs(h1 - h2) <= 180) mean_h = (h1 + h2) / 2;
    else mean_h = h1 + h2 < 360 ? (h1 + h2 + 360) / 2 : (h1 + h2 - 360) / 2;
  }
  const long double dl = second.l - first.l, dc = c2 - c1,
                    dh = 2 * sqrt(c1 * c2) * sin(radians(turn / 2));
  const long double l = (first.l + second.l) / 2, c = (c1 + c2) / 2;
  const long double t = 1 - 0.17L * cos(radians(mean_h - 30)) + 0.24L * cos(radians(2 * mean_h)) +
                        0.32L * cos(radians(3 * mean_h + 6)) -
                        0.20L * cos(radians(4 * mean_h - 63));
  const long double bell = (mean_h - 275) / 25;
  const long double rotation = -sin(radians(60 * exp(-bell * bell))) * 2 * saturating(c);
  const long double squared = (l - 50) * (l - 50);
  const long double sl = 1 + 0.015L * squared / sqrt(20 + squared), sc = 1 + 0.045L * c,
                    sh = 1 + 0.015L * c * t;
  const long double x = dl / sl, y = dc / sc, z = dh / sh;
  return x * x + y * y + z * z + rotation * y * z;
}

}  // namespace sir::test
