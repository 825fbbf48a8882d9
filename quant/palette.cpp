#include "quant/palette.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <utility>

#include "quant/clones.h"
#include "quant/lattice_place.h"

namespace sir::quant {
namespace {

constexpr float kFar = 1e9f;  // its square is a float yet

}  // namespace

Palette::Palette(std::span<const ColourPoint> points, ColourMeasure& measure, const DacBits& dac,
                 const Groups& groups)
    : points_(points),
      measure_(&measure),
      dac_(dac),
      codes_(groups.sums.size()),
      rules_(groups.sums.size()),
      nearest_(groups.of_point),
      sums_(groups.sums),
      around_(groups.sums.size()),
      moved_(groups.sums.size(), 1),
      stirred_(groups.sums.size(), 1),
      unsettled_(groups.sums.size(), 1) {
  for (const FormSum& sum : sums_)
    entries_.push_back(sum.points > 0 ? glm::vec3(sum.best()) : glm::vec3(0));
}

double Palette::cost() const {
  double sum = 0;
  for (std::size_t i = 0; i < size(); ++i) sum += sums_[i].cost(glm::dvec3(entries_[i]));
  return sum;
}

void Palette::move(std::size_t entry, const glm::vec3& to) {
  entries_[entry] = to;
  moved_[entry] = unsettled_[entry] = 1;
}

void Palette::move(std::size_t entry, const DacCode& to) {
  codes_[entry] = to;
  move(entry, measure_->point_of(seen(to, dac_)));
}

void Palette::set(std::size_t entry, const DacCode& code, EntryRule rule) {
  rules_[entry] = std::move(rule);
  move(entry, code);
}

// By the form of the group and from its centre, which is where its points are.
SIR_CLONES void Palette::list(std::size_t group) {
  Around& around = around_[group];
  const FormSum& sum = sums_[group];
  around.centre = sum.points > 0 ? glm::vec3(sum.best()) : entries_[group];
  around.form = sum.points > 0 ? sum.mean_form() : Form{};
  std::array<std::uint64_t, 256> ranked;
  for (std::size_t i = 0; i < size(); ++i)
    ranked[i] =
        std::uint64_t{std::bit_cast<std::uint32_t>(around.form(around.centre - entries_[i]))}
            << 16 |
        i;
  const std::uint64_t own = std::exchange(ranked[group], group);  // first, however far
  const std::size_t count = std::min(kAround, size());
  const auto from = ranked.begin(), last = from + static_cast<std::ptrdiff_t>(count) - 1;
  std::nth_element(from, last, from + static_cast<std::ptrdiff_t>(size()));
  const auto far = static_cast<std::uint32_t>(std::max(*last, own) >> 16);
  around.reach =
      count < size() ? std::bit_cast<float>(far) : std::numeric_limits<float>::infinity();
  // By index, so that ties depend on nothing else.
  for (auto one = from; one <= last; ++one) *one &= 0xFFFF;
  std::sort(from, last + 1);
  for (std::size_t k = 0; k < kAround; ++k) {
    const auto index = static_cast<std::uint16_t>(k < count ? ranked[k] : group);
    if (k < count && index == group) around.own = k;
    around.index[k] = index;
    around.x[k] = k < count ? entries_[index].x : kFar;
    around.y[k] = k < count ? entries_[index].y : kFar;
    around.z[k] = k < count ? entries_[index].z : kFar;
  }
}

// Makes the list anew where another entry may belong to it. True where the points of the group
// must look for their entry again.
bool Palette::refresh(std::size_t group, std::span<const std::uint16_t> moved) {
  Around& around = around_[group];
  bool again = stirred_[group] || around.reach < 0;
  bool look = again;
  for (const std::uint16_t entry : moved) {
    if (again) break;
    again = around.form(around.centre - entries_[entry]) < around.reach;
    look = look || again;
  }
  for (const std::uint16_t entry : around.index) look = look || moved_[entry];
  if (look) list(group);
  return look;
}

Palette::Differences Palette::differences(const ColourPoint& point, const Around& around) {
  Differences differences;
  const Form form = point.form;
  for (std::size_t k = 0; k < kAround; ++k) {
    const float x = point.at.x - around.x[k], y = point.at.y - around.y[k],
                z = point.at.z - around.z[k];
    differences[k] = std::bit_cast<std::int32_t>(
        form.xx * x * x + (form.yy * y * y + form.zz * z * z + form.yz * y * z));
  }
  return differences;
}

SIR_CLONES void Palette::assign() {
  std::vector<std::uint16_t> moved;
  for (std::size_t i = 0; i < size(); ++i)
    if (moved_[i]) moved.push_back(static_cast<std::uint16_t>(i));
  std::vector<std::uint8_t> look(size());
  for (std::size_t group = 0; group < size(); ++group) look[group] = refresh(group, moved);
  std::fill(moved_.begin(), moved_.end(), std::uint8_t{0});
  std::fill(stirred_.begin(), stirred_.end(), std::uint8_t{0});
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const std::uint16_t group = nearest_[i];
    if (!look[group]) continue;
    const Around& around = around_[group];
    const ColourPoint& point = points_[i];
    const Differences difference = differences(point, around);
    std::int32_t least = difference[0];
    for (std::size_t k = 1; k < kAround; ++k) least = std::min(least, difference[k]);
    std::size_t found = 0;
    while (difference[found] != least) ++found;
    const std::uint16_t entry = around.index[found];
    if (entry == group) continue;
    nearest_[i] = entry;
    sums_[group].remove(point);
    sums_[entry].add(point);
    stirred_[group] = stirred_[entry] = unsettled_[group] = unsettled_[entry] = 1;
  }
}

void Palette::place(std::size_t entry) {
  constexpr double kTooLittle = 1e-3;  // such a gain is not worth that all around look again
  const FormSum& sum = sums_[entry];
  if (rules_[entry].fixed || sum.points == 0) return;
  if (held_) {
    const DacCode code = best_code(sum, dac_, *measure_, &codes_[entry], rules_[entry].allowed);
    if (code != codes_[entry]) move(entry, code);
  } else {
    const glm::dvec3 best = sum.best();
    if (sum.cost(best) < sum.cost(glm::dvec3(entries_[entry])) * (1 - kTooLittle))
      move(entry, glm::vec3(best));
  }
}

double Palette::step() {
  const double before = cost();
  for (std::size_t i = 0; i < size(); ++i)
    if (stirred_[i] || moved_[i]) place(i);
  assign();
  const double after = cost();
  return before > 0 ? 1 - after / before : 0;
}

void Palette::hold() {
  held_ = true;
  for (std::size_t i = 0; i < size(); ++i) {
    if (!rules_[i].free()) continue;
    if (sums_[i].points == 0) {  // else it might win points where no code is
      move(i, codes_[i]);
      continue;
    }
    // One that is on the lattice already must not end worse.
    const bool there = entries_[i] == measure_->point_of(seen(codes_[i], dac_));
    move(i, best_code(sums_[i], dac_, *measure_, there ? &codes_[i] : nullptr));
  }
  assign();
}

Palette::Order Palette::order() const {
  Order order{std::vector<std::uint32_t>(size() + 1), std::vector<std::uint32_t>(points_.size())};
  for (const std::uint16_t entry : nearest_) ++order.start[entry + 1u];
  std::partial_sum(order.start.begin(), order.start.end(), order.start.begin());
  auto next = order.start;
  for (std::uint32_t i = 0; i < points_.size(); ++i) order.points[next[nearest_[i]]++] = i;
  return order;
}

SIR_CLONES float Palette::second(const ColourPoint& point, std::size_t entry) const {
  const Around& around = around_[entry];
  Differences difference = differences(point, around);
  difference[around.own] = std::bit_cast<std::int32_t>(std::numeric_limits<float>::infinity());
  std::int32_t least = difference[0];
  for (std::size_t k = 1; k < kAround; ++k) least = std::min(least, difference[k]);
  return std::bit_cast<float>(least);
}

SIR_CLONES std::vector<double> Palette::missed() const {
  std::vector<double> missed(size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const std::size_t entry = nearest_[i];
    const ColourPoint& point = points_[i];
    const double gain =
        static_cast<double>(second(point, entry) - point.form(point.at - entries_[entry]));
    missed[entry] += static_cast<double>(point.weight) * gain;
  }
  return missed;
}

}  // namespace sir::quant
