// Compares the tracer's answer to a hard ray with the exact one, by the measure
// stated for double and for float.
#pragma once

#include <string>
#include <vector>

#include "tests/exact_oracle.h"
#include "tests/hard_rays.h"
#include "tracer/probe.h"

namespace sir::test {

/// Double: |t| off by more than this share needs the backward criterion.
inline constexpr double kRelativeError = 1e-12;
/// Roundings (2^-53) of every input that may be needed to explain t.
inline constexpr double kBackwardRoundings = 8;
/// No excuse beyond this share, unless t is lost in the roundings of the inputs.
inline constexpr double kRelativeErrorAtAll = 1e-9;

/// Float: roundings (2^-24) of every input that a definite answer must stand.
inline constexpr double kFloatRoundings = 4;
/// Share of the larger of |t| and the size of the scene by which t may be off.
inline constexpr double kFloatError = 1e-4;

/// What became of one ray.
struct Verdict {
  bool same_list = false;         ///< (node, face, side) of every boundary
  bool right = false;             ///< and every t as it must be
  double relative_error = 0;      ///< worst over the hits; float: share of max(|t|, size)
  double backward_roundings = 0;  ///< worst over the hits (double only)
  std::string reason;             ///< why it is wrong
};

/// Double. Lists must agree in (node, face, side); every t must be right.
Verdict judge_double(const ExactOracle& oracle, const HardRay& ray, const ExactAnswer& exact,
                     const std::vector<ProbeHit>& found);

/// Float: the same list, t within kFloatError. `size` as seen_size().
Verdict judge_float(const ExactAnswer& exact, const std::vector<ProbeHit>& found, double size);

/// The ray with the nearest float components; the direction may have any length.
HardRay in_float(const HardRay& ray);

/// Whether a case is in the domain of float: for every primitive the condition
/// number is at most 1e4, the eye and the origin are within 1e3 sizes of its
/// middle, and its size is within a factor 1e3 of the others'.
bool in_float_domain(const HardRay& ray);

/// The allowance for float: none for a scene and a ray in multiples of 1/64 up to
/// 64, which rounding to float does not change; else kFloatRoundings.
Allowance float_allowance(const HardRay& ray);

/// Size of the largest primitive, in units of the ray's direction.
double seen_size(const HardRay& ray);

/// Whether slack leaves room for kFloatError: else float cannot give t.
bool times_fit_float(const ExactAnswer& exact, double size);

/// A case in full: ray with 17 digits, the solids, both lists.
std::string describe(const HardRay& ray, const ExactAnswer& exact,
                     const std::vector<ProbeHit>& found);

}  // namespace sir::test
