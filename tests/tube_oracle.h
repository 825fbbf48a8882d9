// A tube's colours by matrices of chromaticities in long double: nothing of lcms2, nothing of ours.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace sir::test {

using Three = std::array<long double, 3>;
using Nine = std::array<Three, 3>;  // rows

struct Xy {
  long double x, y;
  Three xyz() const { return {x / y, 1, (1 - x - y) / y}; }
};

inline long double determinant(const Nine& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// x of m x = b, by Cramer's rule.
inline Three solve(const Nine& m, const Three& b) {
  Three x{};
  for (std::size_t column = 0; column < 3; ++column) {
    Nine changed = m;
    for (std::size_t row = 0; row < 3; ++row) changed[row][column] = b[row];
    x[column] = determinant(changed) / determinant(m);
  }
  return x;
}

inline Three times(const Nine& m, const Three& v) {
  Three sum{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) sum[row] += m[row][column] * v[column];
  return sum;
}

/// XYZ of the primaries in its columns, so that all of them at 1 are the white with Y = 1.
inline Nine to_xyz(const std::array<Xy, 3>& primary, const Xy& white) {
  Nine m{};
  for (std::size_t column = 0; column < 3; ++column)
    for (std::size_t row = 0; row < 3; ++row) m[row][column] = primary[column].xyz()[row];
  const Three amount = solve(m, white.xyz());
  for (Three& row : m)
    for (std::size_t column = 0; column < 3; ++column) row[column] *= amount[column];
  return m;
}

inline const Nine& srgb_to_xyz() {
  static const Nine m =
      to_xyz({{{0.64L, 0.33L}, {0.30L, 0.60L}, {0.15L, 0.06L}}}, {0.3127L, 0.3290L});
  return m;
}

/// Linear light by the primaries of sRGB, white dimmed until no primary is above 1.
inline Three tube_light(const std::array<Xy, 3>& primary, const Xy& white, long double gamma,
                        const Three& voltages) {
  const Nine tube = to_xyz(primary, white);
  const Three brightest = solve(srgb_to_xyz(), white.xyz());
  const long double most = std::max({brightest[0], brightest[1], brightest[2]});
  Three gun{};
  for (std::size_t c = 0; c < 3; ++c) gun[c] = std::pow(voltages[c], gamma) / most;
  return solve(srgb_to_xyz(), times(tube, gun));
}

/// The byte of IEC 61966-2-1, clipped.
inline int srgb_byte(long double light) {
  const long double coded =
      light <= 0.0031308L ? 12.92L * light : 1.055L * std::pow(light, 1 / 2.4L) - 0.055L;
  return static_cast<int>(std::lround(255 * std::min(std::max(coded, 0.0L), 1.0L)));
}

}  // namespace sir::test
