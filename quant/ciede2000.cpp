#include "quant/ciede2000.h"

#include <lcms2.h>

#include <array>
#include <cmath>

#include "quant/image_pair.h"

namespace sir::quant {
namespace {

/// XYZ of the three primaries, white having Y = 1.
constexpr double kToXyz[3][3] = {{0.4124564, 0.3575761, 0.1804375},
                                 {0.2126729, 0.7151522, 0.0721750},
                                 {0.0193339, 0.1191920, 0.9503041}};

double linear(double coded) {
  return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

const std::array<double, 256>& linear_bytes() {
  static const auto table = [] {
    std::array<double, 256> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = linear(static_cast<double>(i) / 255);
    return bytes;
  }();
  return table;
}

cmsCIEXYZ xyz_of_linear(double r, double g, double b) {
  const auto row = [&](int i) { return kToXyz[i][0] * r + kToXyz[i][1] * g + kToXyz[i][2] * b; };
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
  return lab_of_linear(linear(colour.r), linear(colour.g), linear(colour.b));
}

Lab lab_of(Rgb8 colour) {
  const auto& bytes = linear_bytes();
  return lab_of_linear(bytes[colour.r], bytes[colour.g], bytes[colour.b]);
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
