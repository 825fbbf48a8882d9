#include "quant/best.h"

#include <algorithm>
#include <cmath>
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

class Choice {
 public:
  Choice(const WeightedColours& colours, const BestOptions& options, Refinement refinement)
      : colours_(colours),
        options_(options),
        refinement_(std::move(refinement)),
        places_(places_of(options)),
        measure_(options.goal),
        points_(colours.points(measure_, refinement_.points())) {
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
    // Those of a LUT to start from may be the same, as where its last one is repeated.
    if (options_.from)
      choice.entries =
          std::max(std::set<DacCode>(codes.begin(), codes.end()).size(), options_.pins.size());
    choice.error = error_of(codes);
    return choice;
  }

 private:
  void choose(std::vector<DacCode>& codes, std::vector<int>& lost_hues) {
    const auto floor = lattice_colours();
    Palette palette = floor ? on_lattice(*floor) : off_lattice();
    if (!floor) refinement_.free(palette);
    palette.hold();
    refinement_.held(palette);
    if (options_.protect_hues) {
      lost_hues = guard_hues(palette, colours_.all(), measure_, options_.dac);
      refinement_.held(palette);
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

  SweepSearch search_among(std::span<const DacCode> codes) {
    std::vector<glm::vec3> entries;
    for (const DacCode& code : codes)
      entries.push_back(measure_.point_of(seen(code, options_.dac)));
    return SweepSearch(entries);
  }

  // Pins first, then entries at these codes; points with the nearest of them.
  Palette at_codes(std::vector<DacCode> codes) {
    const std::size_t pins = options_.pins.size();
    std::vector<DacCode> pinned;
    for (const Pin& pin : options_.pins) pinned.push_back(pin.code);
    codes.insert(codes.begin(), pinned.begin(), pinned.end());
    const SweepSearch search = search_among(codes);
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
    const SweepSearch search = search_among(codes);
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
  Refinement refinement_;
  Places places_;
  ColourMeasure measure_;
  ColourPoints points_;         // those of small hues with more weight
  std::vector<float> weights_;  // without
};

}  // namespace

BestChoice choose_best(const WeightedColours& colours, const BestOptions& options,
                       const ProgressTo& progress, std::stop_token stop) {
  Refinement refinement(options.effort, progress, std::move(stop));
  if (options.from && options.from->dac != options.dac)
    throw std::invalid_argument("the LUT to start from is of another DAC");
  if (colours.all().empty()) throw std::invalid_argument("there are no colours to choose from");
  return Choice(colours, options, std::move(refinement)).run();
}

}  // namespace sir::quant
