// A colour tube: from the voltages of its three guns to light. The thesis says nothing of it
// (3.4: only codes from 0 to 63); all of this is our model.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "eltek/phosphor.h"
#include "quant/linear_light.h"

namespace sir::eltek {

/// The voltages of red, green and blue, 0 (no light) to 1 (the most).
using Voltages = std::array<double, 3>;

struct TubeOptions {
  PhosphorSet phosphors = PhosphorSet::smpte_c;
  WhitePoint white = WhitePoint::d65;
  /// A gun's light is the voltage to this power: 1 to 4. Tubes have 2.2 to 2.5.
  double gamma = 2.2;
  bool valid() const { return gamma >= 1 && gamma <= 4; }
  friend bool operator==(const TubeOptions&, const TubeOptions&) = default;
};

/// Light is given by the primaries of sRGB, in proportion to its energy (quant::Light), as the eye
/// sees it beside an sRGB screen: a white of 9300 K stays bluish, for nothing is adapted. It is
/// dimmed by gain(), so that white is as bright as sRGB can show it. A colour that sRGB does not
/// have has parts below 0 or above 1: whoever makes bytes of it clips them.
///
/// Copies share what is costly. Safe for several threads.
class Tube {
 public:
  /// Throws std::invalid_argument for options that are not valid.
  explicit Tube(const TubeOptions& options = {});

  const TubeOptions& options() const { return options_; }

  /// What all light is multiplied by, 0 to 1; 1 for D65.
  double gain() const { return gain_; }

  std::vector<quant::Light> light_of(std::span<const Voltages> voltages) const;

 private:
  TubeOptions options_;
  std::shared_ptr<void> transform_;  // of lcms2
  double gain_ = 1;
};

}  // namespace sir::eltek
