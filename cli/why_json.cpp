#include "cli/why_json.h"

#include <variant>

#include <nlohmann/json.hpp>

namespace sir::cli {
namespace {

using nlohmann::ordered_json;

ordered_json as_json(Rgb8 c) { return {c.r, c.g, c.b}; }

ordered_json as_json(const viewer::EntryDistance& one) {
  return {{"index", one.index},
          {"seen", as_json(one.seen)},
          {"d2", one.squared},
          {"de", one.difference}};
}

ordered_json as_json(const viewer::NearestTwo& two) {
  ordered_json json = ordered_json::array({as_json(two.winner)});
  if (two.runner_up) json.push_back(as_json(*two.runner_up));
  return json;
}

ordered_json as_json(const quant::CellBox& box) {
  return {{"low", box.low}, {"high", box.high}, {"pixels", box.pixels}, {"cells", box.cells}};
}

void add(ordered_json&, const quant::NotCounted&) {}

void add(ordered_json& json, const quant::OwnEntry&) { json["own_entry"] = true; }

void add(ordered_json& json, const quant::FrequencyRank& rank) {
  json["rank"] = rank.rank;
  json["last_chosen"] = rank.last_chosen;
}

void add(ordered_json& json, const quant::CutPath& path) {
  json["splits"] = ordered_json::array();
  for (const quant::Descent& step : path.splits) {
    const quant::BoxSplit& split = step.split;
    ordered_json one = as_json(split.box);
    one["axis"] = split.axis;
    one["last"] = split.last;
    one["half"] = step.upper ? "upper" : "lower";
    one["lower_pixels"] = split.lower_pixels;
    one["upper_pixels"] = split.box.pixels - split.lower_pixels;
    json["splits"].push_back(std::move(one));
  }
  json["box"] = path.box.cells > 0 ? as_json(path.box) : ordered_json();
}

ordered_json why(const viewer::PixelShown& shown) {
  ordered_json json{{"method", viewer::name(shown.method)}, {"lut", shown.lut_name}};
  if (!shown.origin) return json;
  const quant::CellOrigin& origin = *shown.origin;
  json["space"] = shown.choice.space == quant::Space::rgb ? "rgb" : "hsv";
  json["cell"] = {{"at", origin.cell}, {"grey", origin.grey}, {"pixels", origin.pixels}};
  json["plane"] = {{"number", origin.plane},
                   {"cells", origin.plane_cells},
                   {"pixels", origin.plane_pixels},
                   {"entries", origin.plane_entries}};
  std::visit([&](const auto& how) { add(json, how); }, origin.how);
  json["entry"] = shown.made ? as_json(*shown.made) : ordered_json();
  return json;
}

ordered_json as_json(const viewer::PixelShown& shown) {
  ordered_json group{{"pixels", shown.group.pixels},
                     {"of", shown.image_pixels},
                     {"colours", shown.group.colours},
                     {"mean", {shown.group.mean.x, shown.group.mean.y, shown.group.mean.z}},
                     {"spread", shown.group.spread}};
  group["next_entry"] = shown.nearest_other ? as_json(*shown.nearest_other) : ordered_json();
  return {{"seen", as_json(shown.entry.seen)},
          {"index", shown.entry.index},
          {"code", shown.code},
          {"de", shown.entry.difference},
          {"d2", shown.entry.squared},
          {"dithered", shown.dithered},
          {"nearest",
           {{"bytes", as_json(shown.by_bytes)},
            {"eye", shown.by_eye ? as_json(*shown.by_eye) : ordered_json()}}},
          {"why", why(shown)},
          {"group", std::move(group)}};
}

ordered_json as_json(const viewer::RayFind& ray) {
  if (!ray.hit) return {{"hit", false}};
  return {{"hit", true},      {"node", ray.node},       {"name", ray.node_name},
          {"face", ray.face}, {"surface", ray.surface}, {"surface_name", ray.surface_name},
          {"t", ray.t}};
}

}  // namespace

ordered_json inspection_json(const viewer::Inspection& found) {
  ordered_json json{{"pixel", {found.column, found.row}}};
  json["screen"] =
      found.screen ? ordered_json{found.screen->column, found.screen->row} : ordered_json();
  json["true"] = as_json(found.true_colour);
  if (found.shown) json.update(as_json(*found.shown));
  json["ray"] = found.ray ? as_json(*found.ray) : ordered_json();
  return json;
}

}  // namespace sir::cli
