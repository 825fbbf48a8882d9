#include <algorithm>
#include <array>
#include <utility>

#include "quant/clones.h"
#include "quant/lattice_place.h"
#include "quant/palette.h"

namespace sir::quant {
namespace {

constexpr std::size_t kLanes = 8;  // summed side by side, so that vector instructions will do

/// The points of all groups in lanes, with their differences from their own entry and from the
/// next one; every group filled up to whole rows of lanes with points of no weight.
class Lanes {
 public:
  void add(const ColourPoint& point, float first, float second) {
    const float values[] = {point.at.x,    point.at.y,    point.at.z,    point.form.xx,
                            point.form.yy, point.form.zz, point.form.yz, point.weight,
                            first,         second};
    const std::size_t lane = used_++ % kLanes;
    if (lane == 0) rows_.push_back({});
    for (std::size_t i = 0; i < kFields; ++i) rows_.back()[i][lane] = values[i];
  }
  void end_group() {
    used_ = 0;
    ends_.push_back(rows_.size());
  }

  /// What a group's points save by an entry, if they may go to it (Own false); or what they save
  /// by it in place of their own entry, whence they may go to the next one (Own true).
  template <bool Own>
  double saved(std::size_t group, const glm::vec3& entry) const {
    std::array<double, kLanes> sum{};
    for (std::size_t row = group == 0 ? 0 : ends_[group - 1]; row < ends_[group]; ++row) {
      const auto& [px, py, pz, xx, yy, zz, yz, weight, first, second] = rows_[row];
      std::array<float, kLanes> saving;
      for (std::size_t k = 0; k < kLanes; ++k) {
        const float x = px[k] - entry.x, y = py[k] - entry.y, z = pz[k] - entry.z;
        const float difference = xx[k] * x * x + (yy[k] * y * y + zz[k] * z * z + yz[k] * y * z);
        const float other = Own ? second[k] : first[k];
        saving[k] = weight[k] * (first[k] - (difference < other ? difference : other));
      }
      for (std::size_t k = 0; k < kLanes; ++k) sum[k] += static_cast<double>(saving[k]);
    }
    double total = 0;
    for (const double one : sum) total += one;
    return total;
  }

 private:
  static constexpr std::size_t kFields = 10;
  std::vector<std::array<std::array<float, kLanes>, kFields>> rows_;
  std::vector<std::size_t> ends_;
  std::size_t used_ = 0;
};

struct Move {
  double gain = 0;
  std::size_t entry = 0;
  DacCode code{};
};

}  // namespace

SIR_CLONES std::size_t Palette::nudge(std::size_t tries) {
  constexpr std::size_t kTouched = 8;  // neighbours whose points are asked
  Order groups = order();
  Lanes lanes;
  std::vector<std::vector<std::uint16_t>> touched(size());
  std::vector<std::uint8_t> look(size());
  for (std::size_t i = 0; i < size(); ++i) {
    std::vector<std::pair<float, std::uint16_t>> near;
    const Form form = sums_[i].points > 0 ? sums_[i].mean_form() : Form{};
    for (const std::uint16_t other : around_[i].index)
      if (other != i && (near.empty() || near.back().second != other))
        near.push_back({form(entries_[i] - entries_[other]), other});
    std::sort(near.begin(), near.end());
    if (near.size() > kTouched) near.resize(kTouched);
    bool any = unsettled_[i];
    for (const auto& [unused, other] : near) {
      touched[i].push_back(other);
      any = any || unsettled_[other];
    }
    look[i] = any && rules_[i].free() && sums_[i].points > 0;
    for (const std::uint32_t p : groups.of(i)) {
      const ColourPoint& point = points_[p];
      lanes.add(point, point.form(point.at - entries_[i]), look[i] ? second(point, i) : 0);
    }
    lanes.end_group();
  }

  std::vector<Move> moves;
  for (std::size_t i = 0; i < size(); ++i) {
    if (!look[i]) continue;
    std::vector<std::pair<double, DacCode>> codes;
    for_each_around(codes_[i], dac_, 1, [&](const DacCode& code) {
      codes.push_back({sums_[i].cost(glm::dvec3(measure_->point_of(seen(code, dac_)))), code});
    });
    std::sort(codes.begin(), codes.end());
    if (codes.size() > tries) codes.resize(tries);
    Move best{0, i, codes_[i]};
    for (const auto& [unused, code] : codes) {
      const glm::vec3 entry = measure_->point_of(seen(code, dac_));
      double gain = lanes.saved<true>(i, entry);
      for (const std::uint16_t other : touched[i]) gain += lanes.saved<false>(other, entry);
      if (gain > best.gain) best = {gain, i, code};
    }
    if (best.gain > 0) moves.push_back(best);
  }
  std::fill(unsettled_.begin(), unsettled_.end(), std::uint8_t{0});
  for (const Move& one : moves) unsettled_[one.entry] = 1;  // those that must wait ask again
  std::stable_sort(moves.begin(), moves.end(),
                   [](const Move& a, const Move& b) { return a.gain > b.gain; });

  const Palette before = *this;
  std::vector<std::uint8_t> busy(size());
  std::size_t moved = 0;
  for (const Move& one : moves) {
    const auto& others = touched[one.entry];
    if (busy[one.entry]) continue;
    busy[one.entry] = 1;
    for (const std::uint16_t other : others) busy[other] = 1;
    move(one.entry, one.code);
    ++moved;
  }
  if (moved == 0) return 0;
  assign();
  if (cost() < before.cost()) return moved;
  *this = before;  // what remains is below the rounding of floats
  return 0;
}

}  // namespace sir::quant
