#include "quant/colour_measure.h"

#include <array>
#include <cmath>
#include <numbers>

#include "quant/image_pair.h"
#include "quant/linear_light.h"
#include "quant/srgb.h"

namespace sir::quant {
namespace {

constexpr int kPointBits = 15;
constexpr int kCubeBits = 2;  // 4 levels a side
constexpr int kSideBits = 8 - kCubeBits;

std::size_t cube_of(Rgb8 colour) {
  return (std::size_t{colour.r} >> kCubeBits) << 2 * kSideBits |
         (std::size_t{colour.g} >> kCubeBits) << kSideBits | std::size_t{colour.b} >> kCubeBits;
}

Rgb cube_centre(Rgb8 colour) {
  constexpr int kSide = 1 << kCubeBits;
  const auto centre = [](std::uint8_t byte) {
    return (byte / kSide * kSide + 0.5 * (kSide - 1)) / 255;
  };
  return {centre(colour.r), centre(colour.g), centre(colour.b)};
}

// What a byte of each primary adds to X, Y and Z over those of white.
using Shares = std::array<std::array<glm::vec3, 256>, 3>;

const Shares& shares() {
  static const Shares table = [] {
    Shares all{};
    for (std::size_t primary = 0; primary < 3; ++primary)
      for (std::size_t byte = 0; byte < 256; ++byte)
        for (int row = 0; row < 3; ++row) {
          const auto& xyz = kLinearToXyz[row];
          all[primary][byte][row] = static_cast<float>(
              xyz[primary] * LinearLight::table().of(static_cast<std::uint8_t>(byte)) /
              (xyz[0] + xyz[1] + xyz[2]));
        }
    return all;
  }();
  return table;
}

// Of CIELAB (CIE 15).
float curve(float ratio) {
  constexpr float kSmall = 216.0f / 24389;
  return ratio > kSmall ? std::cbrt(ratio) : ratio * (841.0f / 108) + 4.0f / 29;
}

glm::vec3 lab_point(Rgb8 colour) {
  const Shares& table = shares();
  const glm::vec3 sum = table[0][colour.r] + table[1][colour.g] + table[2][colour.b];
  const float x = curve(sum.x), y = curve(sum.y), z = curve(sum.z);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// An orthonormal basis whose first axis is the grey one.
glm::vec3 turned_bytes(Rgb8 colour) {
  constexpr float kThird = 0.57735026919f, kHalf = 0.70710678119f, kSixth = 0.40824829046f;
  const float r = colour.r, g = colour.g, b = colour.b;
  return {kThird * (r + g + b), kHalf * (r - b), kSixth * (r - 2 * g + b)};
}

}  // namespace

Form local_ciede2000(const Lab& at) {
  constexpr double kDegree = std::numbers::pi / 180;
  const auto seventh = [](double x) { return std::pow(x, 7); };
  const double limit = seventh(25);
  const double chroma7 = seventh(std::hypot(at.a, at.b));
  const double stretch = 1.5 - 0.5 * std::sqrt(chroma7 / (chroma7 + limit));  // of a: 1 + G
  const double a = stretch * at.a;
  const double chroma = std::hypot(a, at.b);
  const double hue = chroma > 0 ? std::atan2(at.b, a) / kDegree : 0;
  const double degrees = hue < 0 ? hue + 360 : hue;

  const double t =
      1 - 0.17 * std::cos((degrees - 30) * kDegree) + 0.24 * std::cos(2 * degrees * kDegree) +
      0.32 * std::cos((3 * degrees + 6) * kDegree) - 0.20 * std::cos((4 * degrees - 63) * kDegree);
  const double from_middle = (at.l - 50) * (at.l - 50);
  const double sl = 1 + 0.015 * from_middle / std::sqrt(20 + from_middle);
  const double sc = 1 + 0.045 * chroma;
  const double sh = 1 + 0.015 * chroma * t;
  const double blue = (degrees - 275) / 25;
  const double turn = -2 * std::sqrt(seventh(chroma) / (seventh(chroma) + limit)) *
                      std::sin(60 * std::exp(-blue * blue) * kDegree);

  // Along chroma and along hue, turned into a' and b. On the grey axis the hue is any.
  const double c = chroma > 0 ? a / chroma : 1, s = chroma > 0 ? at.b / chroma : 0;
  const double cc = 1 / (sc * sc), hh = 1 / (sh * sh), ch = turn / (sc * sh);
  const double aa = cc * c * c + hh * s * s - ch * s * c;
  const double bb = cc * s * s + hh * c * c + ch * s * c;
  const double ab = 2 * (cc - hh) * s * c + ch * (c * c - s * s);
  return {static_cast<float>(1 / (sl * sl)), static_cast<float>(stretch * stretch * aa),
          static_cast<float>(bb), static_cast<float>(stretch * ab)};
}

ColourMeasure::ColourMeasure(Goal goal)
    : goal_(goal),
      points_(std::size_t{1} << kPointBits),
      form_of_cube_(goal == Goal::perceptual ? std::size_t{1} << 3 * kSideBits : 0),
      forms_(1) {}

glm::vec3 ColourMeasure::point_of(Rgb8 colour) {
  if (goal_ == Goal::psnr) return turned_bytes(colour);
  const std::uint32_t key = packed(colour);
  KnownPoint& known = points_[key * 0x9E3779B1u >> (32 - kPointBits)];
  if (known.colour != key) known = {key, lab_point(colour)};
  return known.point;
}

Form ColourMeasure::form_of(Rgb8 colour) {
  if (goal_ == Goal::psnr) return forms_.front();
  std::uint32_t& form = form_of_cube_[cube_of(colour)];
  if (form == 0) {
    form = static_cast<std::uint32_t>(forms_.size());
    forms_.push_back(local_ciede2000(lab_of(cube_centre(colour))));
  }
  return forms_[form];
}

}  // namespace sir::quant
