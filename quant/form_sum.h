// What a group of colours costs under one entry, for any entry, in a few sums.
#pragma once

#include <algorithm>

#include <glm/vec3.hpp>

#include "quant/colour_points.h"

namespace sir::quant {

/// The sum over points p of weight w of  w form_p(x_p - e)  is a quadratic function of the entry
/// e. This keeps its coefficients, so that an entry is judged without visiting the points again.
struct FormSum {
  std::size_t points = 0;
  double weight = 0;
  double xx = 0, yy = 0, zz = 0, yz = 0;  ///< sum of w form
  double x = 0, y = 0, z = 0;             ///< half the slope at 0, negated
  double rest = 0;                        ///< the cost of e = 0
  glm::dvec3 bytes{};                     ///< sum of w (r, g, b)

  void add(const ColourPoint& point) {
    ++points;
    count(point, static_cast<double>(point.weight));
  }
  void remove(const ColourPoint& point) {
    --points;
    count(point, -static_cast<double>(point.weight));
  }

  FormSum& operator+=(const FormSum& other);

  /// The cost of an entry; never below 0.
  double cost(const glm::dvec3& entry) const {
    const auto& e = entry;
    return std::max(0.0, xx * e.x * e.x + yy * e.y * e.y + zz * e.z * e.z + yz * e.y * e.z -
                             2 * (x * e.x + y * e.y + z * e.z) + rest);
  }

  /// Where the cost is least, the entries not being held to any lattice. Of points of some weight.
  glm::dvec3 best() const {
    const double half = 0.5 * yz, determinant = yy * zz - half * half;
    return {x / xx, (y * zz - z * half) / determinant, (z * yy - y * half) / determinant};
  }
  double least() const { return weight > 0 ? cost(best()) : 0; }

  glm::dvec3 mean_bytes() const { return bytes / weight; }
  Form mean_form() const {
    const auto mean = [&](double sum) { return static_cast<float>(sum / weight); };
    return {mean(xx), mean(yy), mean(zz), mean(yz)};
  }

 private:
  void count(const ColourPoint& point, double w) {
    const double fxx = point.form.xx, fyy = point.form.yy, fzz = point.form.zz,
                 half = 0.5 * static_cast<double>(point.form.yz);
    const double px = point.at.x, py = point.at.y, pz = point.at.z;
    const double fx = fxx * px, fy = fyy * py + half * pz, fz = fzz * pz + half * py;
    weight += w;
    xx += w * fxx;
    yy += w * fyy;
    zz += w * fzz;
    yz += w * 2 * half;
    x += w * fx;
    y += w * fy;
    z += w * fz;
    rest += w * (fx * px + fy * py + fz * pz);
    bytes += w * glm::dvec3(point.bytes);
  }
};

}  // namespace sir::quant
