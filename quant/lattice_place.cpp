#include "quant/lattice_place.h"

#include <cmath>

namespace sir::quant {
namespace {

DacCode code_near(const glm::dvec3& bytes, const DacBits& dac) {
  DacCode code{};
  for (std::size_t c = 0; c < 3; ++c) {
    const int most = dac.max_code(c);
    const double exact = bytes[static_cast<int>(c)] * most / 255;
    code[c] = static_cast<std::uint8_t>(std::clamp(static_cast<int>(exact + 0.5), 0, most));
  }
  return code;
}

}  // namespace

DacCode best_code(const FormSum& sum, const DacBits& dac, ColourMeasure& measure,
                  const DacCode* from, const std::function<bool(const DacCode&)>& allowed) {
  const auto cost_of = [&](const DacCode& code) {
    return sum.cost(glm::dvec3(measure.point_of(seen(code, dac))));
  };
  DacCode best = from ? *from : code_near(sum.mean_bytes(), dac);
  double least = cost_of(best);
  for (int reach = 1; reach <= 2;) {
    const DacCode centre = best;
    for_each_around(centre, dac, reach, [&](const DacCode& code) {
      if (allowed && !allowed(code)) return;
      if (const double cost = cost_of(code); cost < least) {
        least = cost;
        best = code;
      }
    });
    reach = best == centre ? reach + 1 : 1;
  }
  return best;
}

}  // namespace sir::quant
