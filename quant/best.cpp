#include "quant/best.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "quant/best_places.h"
#include "quant/hue_guard.h"
#include "quant/lattice.h"
#include "quant/lattice_place.h"
#include "quant/palette.h"
#include "quant/principal_split.h"
#include "quant/sweep_search.h"

namespace sir::quant {
namespace {

/// How much of each step an effort takes.
struct Effort {
  std::size_t points;  // at most, of colours taken together
  int steps;           // of Lloyd
  double enough;       // a step that saves less of the cost is the last
  int swaps;
  double worth;  // of a swap, see Palette::swap
  int nudges;
  std::size_t tries;  // of a nudge
};
constexpr std::array<Effort, 5> kEfforts{{{8192, 4, 1e-2, 0, 1, 0, 0},
                                          {16384, 6, 2e-3, 4, 1, 6, 4},
                                          {80000, 10, 1e-3, 16, 0.7, 16, 8},
                                          {100000, 20, 1e-4, 40, 0.5, 40, 12},
                                          {std::size_t{1} << 24, 60, 1e-6, 200, 0.4, 200, 26}}};

class Choice {
 public:
  Choice(const WeightedColours& colours, const BestOptions& options)
      : colours_(colours),
        options_(options),
        effort_(kEfforts[static_cast<std::size_t>(options.effort - kMinEffort)]),
        places_(places_of(options)),
        measure_(options.goal),
        points_(colours.points(measure_, effort_.points)) {
    for (const ColourPoint& point : points_.all) weights_.push_back(point.weight);
    if (options.goal == Goal::perceptual) raise_small_hues(points_.all);
  }

  BestChoice run() {
    BestChoice choice;
    std::vector<DacCode> codes;
    for (const Pin& pin : options_.pins) codes.push_back(pin.code);
    if (!places_.free.empty()) choose(codes, choice.lost_hues);
    else if (options_.protect_hues) choice.lost_hues = lost_to_pins();
    choice.lut = placed(codes, places_, options_);
    choice.entries = codes.size();
    choice.error = error_of(codes);
    return choice;
  }

 private:
  void choose(std::vector<DacCode>& codes, std::vector<int>& lost_hues) {
    const auto floor = lattice_colours();
    Palette palette = floor ? on_lattice(*floor) : off_lattice();
    if (!floor) {
      spend_spare(palette);
      lloyd(palette);
      swaps(palette);
      lloyd(palette);
    }
    palette.hold();
    polish(palette);
    if (options_.protect_hues) {
      lost_hues = guard_hues(palette, colours_.all(), measure_, options_.dac);
      polish(palette);
    }
    take(palette, codes);
  }

  // The planes that the pins leave without an entry, where pins are all there is.
  std::vector<int> lost_to_pins() {
    Palette palette = at_codes({});
    palette.hold();
    return guard_hues(palette, colours_.all(), measure_, options_.dac);
  }

  // The codes nearest to the colours, where there are entries for all of them.
  std::optional<std::vector<DacCode>> lattice_colours() const {
    if (options_.from) return std::nullopt;
    const Lattice lattice(options_.dac);
    std::set<DacCode> codes;
    for (const WeightedColour& one : colours_.all()) {
      codes.insert(lattice.nearest(one.colour));
      if (codes.size() > options_.entries) return std::nullopt;
    }
    for (const Pin& pin : options_.pins) codes.erase(pin.code);
    if (codes.size() > places_.free.size()) return std::nullopt;
    return best_of_each(std::vector<DacCode>(codes.begin(), codes.end()));
  }

  // The eye may like a code better that is not the nearest primary by primary: where there are
  // entries for those of all colours, they are the better ones.
  std::vector<DacCode> best_of_each(std::vector<DacCode> nearest) const {
    constexpr std::size_t kFew = 4096;
    if (options_.goal == Goal::psnr || colours_.all().size() > kFew) return nearest;
    ColourMeasure measure(options_.goal);
    std::set<DacCode> best;
    for (const WeightedColour& one : colours_.all()) {
      FormSum sum;
      sum.add(point_of({&one, 1}, measure));
      best.insert(best_code(sum, options_.dac, measure));
      if (best.size() > places_.free.size()) return nearest;
    }
    return {best.begin(), best.end()};
  }

  // Pins first, then entries at these codes; points with the nearest of them.
  Palette at_codes(std::vector<DacCode> codes) {
    const std::size_t pins = options_.pins.size();
    for (std::size_t i = 0; i < pins; ++i)
      codes.insert(codes.begin() + static_cast<std::ptrdiff_t>(i), options_.pins[i].code);
    std::vector<glm::vec3> entries;
    for (const DacCode& code : codes)
      entries.push_back(measure_.point_of(seen(code, options_.dac)));
    const SweepSearch search(entries);
    Groups groups;
    groups.sums.resize(codes.size());
    for (const ColourPoint& point : points_.all) {
      const auto entry = search.nearest(point.at, point.form).index;
      groups.of_point.push_back(static_cast<std::uint16_t>(entry));
      groups.sums[entry].add(point);
    }
    Palette palette(points_.all, measure_, options_.dac, groups);
    for (std::size_t i = 0; i < codes.size(); ++i) palette.set(i, codes[i], {i < pins, {}});
    palette.assign();
    return palette;
  }

  Palette on_lattice(std::vector<DacCode> codes) {
    // Entries to spare stand at a code that is there already, for swaps to take.
    const DacCode any = codes.empty() ? options_.pins.front().code : codes.front();
    codes.resize(places_.free.size(), any);
    return at_codes(std::move(codes));
  }

  Palette off_lattice() {
    if (options_.from) {
      std::vector<DacCode> codes;
      for (const std::size_t index : places_.free) codes.push_back(options_.from->entry[index]);
      return at_codes(std::move(codes));
    }
    Groups groups = split_into(points_.all, places_.free.size());
    const std::size_t pins = options_.pins.size();
    groups.sums.insert(groups.sums.begin(), pins, FormSum{});
    for (std::uint16_t& group : groups.of_point) group = static_cast<std::uint16_t>(group + pins);
    Palette palette(points_.all, measure_, options_.dac, groups);
    for (std::size_t i = 0; i < pins; ++i) palette.set(i, options_.pins[i].code, {true, {}});
    palette.assign();
    return palette;
  }

  void lloyd(Palette& palette) const {
    for (int i = 0; i < effort_.steps; ++i)
      if (palette.step() <= effort_.enough) break;
  }

  // Many at once as long as that helps, then fewer.
  void swaps(Palette& palette) const {
    std::size_t most = std::max<std::size_t>(palette.size() / 16, 1);
    for (int i = 0; i < effort_.swaps; ++i) {
      const double before = palette.cost();
      const std::size_t moved = palette.swap(most, effort_.worth);
      if (most == 1 && moved == 0) break;
      if (2 * moved < most || palette.cost() > before * (1 - effort_.enough))
        most = std::max<std::size_t>(most / 2, 1);
    }
  }

  // Entries without colours go where they help: a LUT to start from may repeat its last one, and
  // on a coarse lattice entries fall together. Each round may double those that are used.
  void spend_spare(Palette& palette) const {
    for (;;) {
      std::size_t spare = 0;
      for (std::size_t i = 0; i < palette.size(); ++i)
        spare += palette.rule(i).free() && palette.sum(i).points == 0;
      if (spare == 0 || palette.swap(spare, effort_.worth) == 0) break;
    }
  }

  void polish(Palette& palette) const {
    lloyd(palette);
    spend_spare(palette);
    if (options_.effort > kUsualEffort) swaps(palette);
    for (int i = 0; i < effort_.nudges; ++i)
      if (palette.nudge(effort_.tries) == 0) break;
    lloyd(palette);
  }

  // The chosen codes, each once, those that serve no colour left out.
  void take(const Palette& palette, std::vector<DacCode>& codes) {
    const std::size_t pins = options_.pins.size();
    if (options_.from) {  // all of them, to keep their order; as they were where nothing is gained
      std::vector<DacCode> same = codes;
      for (const std::size_t index : places_.free) same.push_back(options_.from->entry[index]);
      codes.assign(palette.codes().begin(), palette.codes().end());
      if (!options_.protect_hues && error_of(same) <= error_of(codes)) codes = same;
      return;
    }
    std::set<DacCode> known(codes.begin(), codes.end());
    std::vector<std::pair<float, DacCode>> by_light;
    for (std::size_t i = pins; i < palette.size(); ++i) {
      const DacCode& code = palette.codes()[i];
      if (palette.sum(i).points == 0 && palette.rule(i).free()) continue;
      if (known.insert(code).second)
        by_light.push_back({measure_.point_of(seen(code, options_.dac)).x, code});
    }
    std::sort(by_light.begin(), by_light.end());
    for (const auto& [unused, code] : by_light) codes.push_back(code);
  }

  double error_of(std::span<const DacCode> codes) {
    std::vector<glm::vec3> entries;
    for (const DacCode& code : codes)
      entries.push_back(measure_.point_of(seen(code, options_.dac)));
    const SweepSearch search(entries);
    double sum = points_.scatter, weight = 0;
    for (std::size_t i = 0; i < points_.all.size(); ++i) {
      const ColourPoint& point = points_.all[i];
      const double w = weights_[i];
      sum += w * static_cast<double>(search.nearest(point.at, point.form).difference);
      weight += w;
    }
    return std::sqrt(sum / weight);
  }

  const WeightedColours& colours_;
  const BestOptions& options_;
  const Effort& effort_;
  Places places_;
  ColourMeasure measure_;
  ColourPoints points_;         // those of small hues with more weight
  std::vector<float> weights_;  // without
};

}  // namespace

BestChoice choose_best(const WeightedColours& colours, const BestOptions& options) {
  if (options.effort < kMinEffort || options.effort > kMaxEffort)
    throw std::invalid_argument("an effort is from 1 to 5");
  if (options.from && options.from->dac != options.dac)
    throw std::invalid_argument("the LUT to start from is of another DAC");
  if (colours.all().empty()) throw std::invalid_argument("there are no colours to choose from");
  return Choice(colours, options).run();
}

}  // namespace sir::quant
