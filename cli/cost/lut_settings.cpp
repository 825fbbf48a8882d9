#include "cli/cost/lut_settings.h"

#include <array>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "cli/cost/best_words.h"

namespace sir::cli {
namespace {

using quant::BestOptions;
using quant::ChooseOptions;
using quant::Dither;
using quant::Goal;
using quant::Method;
using quant::Space;
using quant::SplitOrder;

class List {
 public:
  explicit List(const KnobSet& only) : only_(only) {
    rows_.push_back({});
    rows_.back().name = "median hsv --split pixels";
    rows_.back().subject = "the default (median cut in HSV)";
  }

  LutSetting* add(Knob knob, const std::string& name,
                  const std::function<void(ChooseOptions&)>& change = {}) {
    if (!wants(only_, knob)) return nullptr;
    LutSetting& row = rows_.emplace_back();
    row.knob = knob;
    row.name = row.subject = name;
    if (change) change(std::get<ChooseOptions>(row.choice));
    return &row;
  }

  // A LUT by `best`, mapped by what it is good at.
  LutSetting* add_best(Knob knob, const std::string& name, Goal goal = Goal::perceptual,
                       int effort = quant::kUsualEffort) {
    constexpr std::array<double, 5> kWeights{12, 20, 45, 85, 105};
    LutSetting* row = add(knob, name);
    if (!row) return nullptr;
    BestOptions options;
    options.goal = goal;
    options.effort = effort;
    row->choice = options;
    row->mapping.search = goal == Goal::perceptual ? Search::perceptual : Search::exact;
    row->weight = kWeights[static_cast<std::size_t>(effort - quant::kMinEffort)];
    return row;
  }

  std::vector<LutSetting> take() { return std::move(rows_); }

 private:
  const KnobSet& only_;
  std::vector<LutSetting> rows_;
};

void add_methods(List& list) {
  for (const auto& [name, space] : {std::pair("rgb", Space::rgb), std::pair("hsv", Space::hsv)}) {
    list.add(Knob::method, fmt::format("frequency {}", name), [space = space](ChooseOptions& o) {
      o.method = Method::frequency;
      o.space = space;
    });
    for (const auto& [word, order] :
         {std::pair("pixels", SplitOrder::pixels), std::pair("breadth", SplitOrder::breadth),
          std::pair("longest", SplitOrder::longest)})
      if (space == Space::rgb || order != SplitOrder::pixels)  // that is the default
        list.add(Knob::method, fmt::format("median {} --split {}", name, word),
                 [space = space, order = order](ChooseOptions& o) {
                   o.space = space;
                   o.split = order;
                 });
  }
}

// 5 bits are the method's own row, where there is one.
void add_grids(List& list, bool has_methods) {
  for (const int bits : {4, 5, 6})
    if (bits == quant::RgbGrid::kBits && has_methods) continue;
    else if (LutSetting* row = list.add(Knob::grid, fmt::format("median rgb --rgb-bits {}", bits),
                                        [bits](ChooseOptions& o) {
                                          o.space = Space::rgb;
                                          o.rgb_bits = bits;
                                        })) {
      row->family = "rgb grid";
      row->at = bits;
    }
  for (const std::string grid : {"18x15x15", "72x60x60"})
    list.add(Knob::grid, "median hsv --grid " + grid,
             [&](ChooseOptions& o) { quant::parse_grid(grid, o.grid); });
  for (const auto& [s, v] : {std::pair(0.0, 0.0), std::pair(0.05, 0.05), std::pair(0.1, 0.1),
                             std::pair(0.1, 0.2), std::pair(0.2, 0.1), std::pair(0.4, 0.2)})
    list.add(Knob::grid, fmt::format("median hsv --grey-s {:g} --grey-v {:g}", s, v),
             [s = s, v = v](ChooseOptions& o) {
               o.grid.grey_s = s;
               o.grid.grey_v = v;
             });
}

void add_samples(List& list) {
  for (const std::size_t sample : {4u, 16u, 64u})
    if (LutSetting* row = list.add(Knob::sample, fmt::format("median hsv --sample {}", sample),
                                   [sample](ChooseOptions& o) { o.sample = sample; })) {
      row->family = "sample";
      row->at = static_cast<double>(sample);
    }
}

void add_searches(List& list) {
  if (LutSetting* row = list.add(Knob::nearest, "nearest by the lattice, approximate"))
    row->mapping.search = Search::approximate;
  if (LutSetting* row = list.add(Knob::nearest, "nearest of all 256, one by one")) {
    row->mapping.search = Search::exhaustive;
    row->weight = 30;
  }
}

void add_efforts(List& list) {
  for (const Goal goal : {Goal::perceptual, Goal::psnr})
    for (int effort = quant::kMinEffort; effort <= quant::kMaxEffort; ++effort)
      if (LutSetting* row = list.add_best(Knob::effort, best_name(goal, effort), goal, effort)) {
        row->family = goal == Goal::perceptual ? kBestByEye : kBestByBytes;
        row->at = effort;
      }
}

void add_maps(List& list, bool has_best) {
  if (!has_best) list.add_best(Knob::map, best_name());
  if (LutSetting* row = list.add_best(Knob::map, kBestMappedByBytes))
    row->mapping.search = Search::exact;
  if (LutSetting* row = list.add(Knob::map, "median hsv, --map perceptual")) {
    row->mapping.search = Search::perceptual;
    row->weight = 10;
  }
}

void add_dithers(List& list, bool has_best) {
  if (!has_best) list.add_best(Knob::dither, best_name());
  for (const auto& [word, kind] :
       {std::pair("floyd", Dither::floyd), std::pair("blue-noise", Dither::blue_noise)}) {
    LutSetting* row = list.add_best(Knob::dither, fmt::format("best, --dither {}", word));
    if (row) row->mapping.dither = kind;
    row = list.add(Knob::dither, fmt::format("median hsv, --dither {}", word));
    if (row) row->mapping.dither = kind;
    if (row) row->weight = 15;
  }
}

void add_combined(List& list) {
  list.add(Knob::combined, "median rgb --split longest --sample 16", [](ChooseOptions& o) {
    o.space = Space::rgb;
    o.split = SplitOrder::longest;
    o.sample = 16;
  });
  if (LutSetting* row =
          list.add(Knob::combined, "median rgb --sample 16, approximate", [](ChooseOptions& o) {
            o.space = Space::rgb;
            o.sample = 16;
          }))
    row->mapping.search = Search::approximate;
  list.add(Knob::combined, "median rgb --rgb-bits 6 --sample 4", [](ChooseOptions& o) {
    o.space = Space::rgb;
    o.rgb_bits = 6;
    o.sample = 4;
  });
  list.add(Knob::combined, "median hsv --grid 72x60x60 --grey-s 0 --grey-v 0",
           [](ChooseOptions& o) {
             o.grid = {72, 60, 60, 0, 0};
           });
}

}  // namespace

std::vector<LutSetting> lut_settings(const KnobSet& only, const std::optional<ChooseOptions>& own) {
  List list(only);
  add_methods(list);
  add_grids(list, wants(only, Knob::method));
  add_samples(list);
  add_searches(list);
  add_efforts(list);
  add_maps(list, wants(only, Knob::effort));
  add_dithers(list, wants(only, Knob::effort) || wants(only, Knob::map));
  add_combined(list);
  auto rows = list.take();
  if (own) {
    LutSetting& row = rows.emplace_back();
    row.name = row.subject = fmt::format("your own: {}x{}x{}, limits {:g} {:g}, sample {}",
                                         own->grid.hues, own->grid.saturations, own->grid.values,
                                         own->grid.grey_s, own->grid.grey_v, own->sample);
    row.choice = *own;
  }
  return rows;
}

}  // namespace sir::cli
