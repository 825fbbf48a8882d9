#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "quant/lattice.h"
#include "quant/palette.h"

namespace sir::quant {

std::size_t Palette::fill() {
  std::vector<std::size_t> spare;
  for (std::size_t i = 0; i < size(); ++i)
    if (rules_[i].free() && sums_[i].points == 0) spare.push_back(i);
  if (spare.empty()) return 0;

  // What a code would gain from the points that it is nearest to, primary by primary.
  const Lattice lattice(dac_);
  std::map<DacCode, double> gains;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const ColourPoint& point = points_[i];
    const auto byte = [](float mean) { return static_cast<std::uint8_t>(mean + 0.5f); };
    const DacCode code =
        lattice.nearest({byte(point.bytes.x), byte(point.bytes.y), byte(point.bytes.z)});
    const float gain = point.form(point.at - entries_[nearest_[i]]) -
                       point.form(point.at - measure_->point_of(seen(code, dac_)));
    if (gain > 0) gains[code] += static_cast<double>(point.weight * gain);
  }
  for (const DacCode& code : codes_) gains.erase(code);
  std::vector<std::pair<double, DacCode>> codes;
  for (const auto& [code, gain] : gains) codes.push_back({-gain, code});
  std::sort(codes.begin(), codes.end());
  const std::size_t moved = std::min(spare.size(), codes.size());
  for (std::size_t i = 0; i < moved; ++i) move(spare[i], codes[i].second);
  if (moved > 0) assign();
  return moved;
}

}  // namespace sir::quant
