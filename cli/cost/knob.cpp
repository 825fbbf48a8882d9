#include "cli/cost/knob.h"

#include <algorithm>
#include <array>
#include <utility>

namespace sir::cli {
namespace {

constexpr std::array<std::pair<Knob, const char*>, 14> kNames{{{Knob::precision, "precision"},
                                                               {Knob::formulas, "formulas"},
                                                               {Knob::depth, "depth"},
                                                               {Knob::cutoff, "cutoff"},
                                                               {Knob::antialias, "antialias"},
                                                               {Knob::preview, "preview"},
                                                               {Knob::combined, "combined"},
                                                               {Knob::method, "method"},
                                                               {Knob::grid, "grid"},
                                                               {Knob::sample, "sample"},
                                                               {Knob::nearest, "nearest"},
                                                               {Knob::effort, "effort"},
                                                               {Knob::map, "map"},
                                                               {Knob::dither, "dither"}}};

bool any_between(const KnobSet& only, Knob first, Knob last) {
  return only.empty() || std::any_of(only.begin(), only.end(),
                                     [&](Knob knob) { return first <= knob && knob <= last; });
}

}  // namespace

const char* name_of(Knob knob) {
  return std::find_if(kNames.begin(), kNames.end(),
                      [&](const auto& known) { return known.first == knob; })
      ->second;
}

std::string known_knobs() {
  std::string list;
  for (const auto& [knob, name] : kNames) list += (list.empty() ? "" : " ") + std::string(name);
  return list;
}

bool wants(const KnobSet& only, Knob knob) { return only.empty() || only.contains(knob); }

bool wants_tracer(const KnobSet& only) {
  return any_between(only, Knob::precision, Knob::combined);
}

bool wants_lut(const KnobSet& only) { return any_between(only, Knob::combined, Knob::dither); }

bool parse_knobs(std::string_view text, KnobSet& knobs) {
  KnobSet read;
  while (true) {
    const auto end = std::min(text.find(','), text.size());
    const auto known = std::find_if(kNames.begin(), kNames.end(), [&](const auto& each) {
      return each.second == text.substr(0, end);
    });
    if (known == kNames.end()) return false;
    read.insert(known->first);
    if (end == text.size()) break;
    text.remove_prefix(end + 1);
  }
  knobs = std::move(read);
  return true;
}

}  // namespace sir::cli
