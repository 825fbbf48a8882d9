#include "quant/ciede2000.h"

#include <lcms2.h>

#include "quant/image_pair.h"
#include "quant/linear_light.h"
#include "quant/srgb.h"

namespace sir::quant {
namespace {

cmsCIEXYZ xyz_of_linear(double r, double g, double b) {
  const auto row = [&](int i) {
    return kLinearToXyz[i][0] * r + kLinearToXyz[i][1] * g + kLinearToXyz[i][2] * b;
  };
  return {row(0), row(1), row(2)};
}

Lab lab_of_linear(double r, double g, double b) {
  // The white is the rows' sums, not its rounded tristimulus: a grey has a = b = 0.
  static const cmsCIEXYZ white = xyz_of_linear(1, 1, 1);
  const cmsCIEXYZ xyz = xyz_of_linear(r, g, b);
  cmsCIELab lab;
  cmsXYZ2Lab(&white, &lab, &xyz);
  return {lab.L, lab.a, lab.b};
}

/// Where among 2^bits slots a key is remembered.
template <int bits>
std::size_t slot_of(std::uint64_t key) {
  return static_cast<std::size_t>(key * 0x9E3779B97F4A7C15u >> (64 - bits));
}

constexpr int kLabBits = 14, kPairBits = 16;

}  // namespace

Lab lab_of(Rgb colour) {
  return lab_of_linear(light_of_coded(colour.r), light_of_coded(colour.g),
                       light_of_coded(colour.b));
}

Lab lab_of(Rgb8 colour) {
  const Light light = LinearLight::table().of(colour);
  return lab_of_linear(light[0], light[1], light[2]);
}

double ciede2000(const Lab& a, const Lab& b) {
  const cmsCIELab first{a.l, a.a, a.b}, second{b.l, b.a, b.b};
  return cmsCIE2000DeltaE(&first, &second, 1, 1, 1);
}

ColourDifference::ColourDifference()
    : labs_(std::size_t{1} << kLabBits), pairs_(std::size_t{1} << kPairBits) {}

const Lab& ColourDifference::lab(Rgb8 colour) {
  const std::uint32_t key = packed(colour);
  KnownLab& known = labs_[slot_of<kLabBits>(key)];
  if (known.colour != key) known = {key, lab_of(colour)};
  return known.lab;
}

double ColourDifference::operator()(Rgb8 a, Rgb8 b) {
  if (a == b) return 0;
  const std::uint64_t key = std::uint64_t{packed(a)} << 24 | packed(b);
  KnownPair& known = pairs_[slot_of<kPairBits>(key)];
  if (known.colours != key) {
    const Lab first = lab(a);  // a copy: the other may take its slot
    known = {key, ciede2000(first, lab(b))};
  }
  return known.difference;
}

std::vector<double> difference_map(const Planes& reference, const Planes& shown) {
  require_pair(reference, shown);
  ColourDifference difference;
  std::vector<double> map(reference.size.pixels());
  for (std::size_t i = 0; i < map.size(); ++i) map[i] = difference(reference.at(i), shown.at(i));
  return map;
}

}  // namespace sir::quant
