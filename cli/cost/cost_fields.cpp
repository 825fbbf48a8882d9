#include "cli/cost/cost_fields.h"

namespace sir::cli {
namespace {

FieldValue of_points(const CostRow& row, FieldValue (*of)(const Difference&)) {
  return row.points ? of(*row.points) : FieldValue();
}

FieldValue of_lut(const CostRow& row, FieldValue (*of)(const LutFigures&)) {
  return row.lut ? of(*row.lut) : FieldValue();
}

using Row = const CostRow&;
using Points = const Difference&;
using Figures = const LutFigures&;

}  // namespace

const std::vector<CostField>& cost_fields() {
  static const std::vector<CostField> fields{
      {"choice", [](Row r) -> FieldValue { return r.name; }},
      {"knob",
       [](Row r) { return r.knob ? FieldValue(std::string(name_of(*r.knob))) : FieldValue(); }},
      {"front", [](Row r) -> FieldValue { return r.front; }},
      {"runs", [](Row r) -> FieldValue { return r.time.runs; }},
      {"ms", [](Row r) -> FieldValue { return r.time.median; }},
      {"ms_low", [](Row r) -> FieldValue { return r.time.low; }},
      {"ms_high", [](Row r) -> FieldValue { return r.time.high; }},
      {"ratio", [](Row r) -> FieldValue { return r.ratio.median; }},
      {"ratio_low", [](Row r) -> FieldValue { return r.ratio.low; }},
      {"ratio_high", [](Row r) -> FieldValue { return r.ratio.high; }},
      {"psnr", [](Row r) -> FieldValue { return comparable(r.picture.psnr); }},
      {"largest", [](Row r) -> FieldValue { return std::size_t(r.picture.largest); }},
      {"de_mean", [](Row r) -> FieldValue { return r.picture.de_mean; }},
      {"pixels", [](Row r) -> FieldValue { return r.picture.pixels; }},
      {"changed", [](Row r) -> FieldValue { return r.changed; }},
      {"points_psnr",
       [](Row r) {
         return of_points(r, [](Points p) -> FieldValue { return comparable(p.psnr); });
       }},
      {"points_largest",
       [](Row r) {
         return of_points(r, [](Points p) -> FieldValue { return std::size_t(p.largest); });
       }},
      {"points_de_mean",
       [](Row r) { return of_points(r, [](Points p) -> FieldValue { return p.de_mean; }); }},
      {"points_pixels",
       [](Row r) { return of_points(r, [](Points p) -> FieldValue { return p.pixels; }); }},
      {"rounded", [](Row r) { return r.rounded ? FieldValue(*r.rounded) : FieldValue(); }},
      {"colours",
       [](Row r) { return of_lut(r, [](Figures f) -> FieldValue { return f.colours; }); }},
      {"entries",
       [](Row r) { return of_lut(r, [](Figures f) -> FieldValue { return f.entries; }); }},
      {"choose_ms",
       [](Row r) {
         return of_lut(r, [](Figures f) -> FieldValue { return spread_of(f.choose_ms).median; });
       }},
      {"map_ms",
       [](Row r) {
         return of_lut(r, [](Figures f) -> FieldValue { return spread_of(f.map_ms).median; });
       }},
      {"rmse", [](Row r) { return of_lut(r, [](Figures f) -> FieldValue { return f.rmse; }); }},
      {"de_p95", [](Row r) { return of_lut(r, [](Figures f) -> FieldValue { return f.de_p95; }); }},
      {"hue_loss",
       [](Row r) { return of_lut(r, [](Figures f) -> FieldValue { return f.hue_loss; }); }},
      {"de_blurred",
       [](Row r) { return of_lut(r, [](Figures f) -> FieldValue { return f.de_blurred; }); }},
  };
  return fields;
}

}  // namespace sir::cli
