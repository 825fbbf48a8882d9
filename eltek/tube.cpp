#include "eltek/tube.h"

#include <lcms2.h>

#include <algorithm>
#include <new>
#include <stdexcept>

namespace sir::eltek {
namespace {

using Profile = std::unique_ptr<void, decltype(&cmsCloseProfile)>;

constexpr std::array<Chromaticity, 3> kSrgb{{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}}};

cmsCIExyY xyY(const Chromaticity& at) { return {at.x, at.y, 1}; }

Profile profile(const std::array<Chromaticity, 3>& primary, WhitePoint at, double gamma) {
  const cmsCIExyY white_point = xyY(white(at).at);
  const cmsCIExyYTRIPLE primaries{xyY(primary[0]), xyY(primary[1]), xyY(primary[2])};
  const std::unique_ptr<cmsToneCurve, decltype(&cmsFreeToneCurve)> curve(
      cmsBuildGamma(nullptr, gamma), cmsFreeToneCurve);
  if (!curve) throw std::bad_alloc();
  cmsToneCurve* curves[3] = {curve.get(), curve.get(), curve.get()};
  Profile made(cmsCreateRGBProfile(&white_point, &primaries, curves), cmsCloseProfile);
  if (!made) throw std::bad_alloc();
  return made;
}

std::shared_ptr<void> transform(const TubeOptions& options) {
  const Profile from = profile(phosphors(options.phosphors).primary, options.white, options.gamma);
  const Profile to = profile(kSrgb, WhitePoint::d65, 1);  // in proportion to energy
  cmsHPROFILE profiles[2] = {from.get(), to.get()};
  cmsBool black_points[2] = {FALSE, FALSE};
  cmsUInt32Number intents[2] = {INTENT_ABSOLUTE_COLORIMETRIC, INTENT_ABSOLUTE_COLORIMETRIC};
  cmsFloat64Number adaptation[2] = {0, 0};  // the eye is not adapted to the tube's white
  // Unoptimized: no tables of 16 bits between. Without a cache it may be used by several threads.
  std::shared_ptr<void> made(
      cmsCreateExtendedTransform(nullptr, 2, profiles, black_points, intents, adaptation, nullptr,
                                 0, TYPE_RGB_DBL, TYPE_RGB_DBL,
                                 cmsFLAGS_NOOPTIMIZE | cmsFLAGS_NOCACHE),
      [](void* done) {
        if (done != nullptr) cmsDeleteTransform(done);
      });
  if (!made) throw std::bad_alloc();
  return made;
}

}  // namespace

Tube::Tube(const TubeOptions& options) : options_(options) {
  if (!options.valid()) throw std::invalid_argument("a tube's gamma is a number from 1 to 4");
  transform_ = transform(options);
  // D65 is sRGB's own white: what is off from 1 there is rounding.
  if (options.white == WhitePoint::d65) return;
  const Voltages most{1, 1, 1};
  const quant::Light brightest = light_of({&most, 1}).front();
  gain_ = 1 / *std::max_element(brightest.begin(), brightest.end());
}

std::vector<quant::Light> Tube::light_of(std::span<const Voltages> voltages) const {
  std::vector<quant::Light> light(voltages.size());
  static_assert(sizeof(Voltages) == 3 * sizeof(double) && sizeof(quant::Light) == sizeof(Voltages));
  cmsDoTransform(transform_.get(), voltages.data(), light.data(),
                 static_cast<cmsUInt32Number>(voltages.size()));
  for (quant::Light& one : light)
    for (double& primary : one) primary *= gain_;
  return light;
}

}  // namespace sir::eltek
