#include "cli/cost/measure.h"
#include "quant/metrics.h"
#include "quant/shown_through.h"
#include "tracer/processor_time.h"

namespace sir::cli {
namespace {

double milliseconds(double from, double to) { return (to - from) * 1e3; }

// The row before its first run.
CostRow row_of(const LutSetting& setting) {
  CostRow row;
  row.knob = setting.knob;
  row.name = setting.name;
  row.subject = setting.subject;
  row.family = setting.family;
  row.at = setting.at;
  row.lut.emplace();
  return row;
}

void judge(const Planes& image, const Planes& shown, CostRow& row) {
  const quant::ImageMetrics metrics = quant::measure(image, shown);
  row.picture = difference_between(image, shown);
  row.lut->rmse = metrics.rmse;
  row.lut->de_p95 = metrics.de_p95;
  row.lut->hue_loss = metrics.hue_loss;
}

}  // namespace

std::optional<CostPart> measure_lut(const Planes& image, const std::vector<LutSetting>& settings,
                                    const MeasureOptions& options) {
  constexpr double kJudging = 50;  // takes about so many runs
  CostPart part;
  for (const LutSetting& setting : settings) part.rows.push_back(row_of(setting));
  const double expected = static_cast<double>(settings.size()) * (kJudging + options.repeats);
  double done = 0;
  const auto tell = [&](double more) {
    done += more;
    if (options.progress) options.progress(done / expected);
  };

  Planes of_default;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (options.stop.stop_requested()) return std::nullopt;
    const auto cells = quant::count_for(image, settings[i].choice);
    const auto lut = quant::choose_from(cells, settings[i].choice);
    const Planes shown = quant::as_seen(image.size, map_by(settings[i].search, image, lut), lut);
    part.rows[i].lut->colours = cells.size();
    part.rows[i].lut->entries = lut.chosen;
    judge(image, shown, part.rows[i]);
    if (i == 0) of_default = shown;
    part.rows[i].changed = pixels_changed(of_default, shown);
    tell(kJudging);
  }

  const auto run = [&](std::size_t i) {
    if (options.stop.stop_requested()) return false;
    const double start = processor_seconds();
    const auto cells = quant::count_for(image, settings[i].choice);
    const auto lut = quant::choose_from(cells, settings[i].choice);
    const double chosen = processor_seconds();
    const auto indices = map_by(settings[i].search, image, lut);
    const double mapped = processor_seconds();
    CostRow& row = part.rows[i];
    row.ms.push_back(milliseconds(start, mapped));
    row.lut->choose_ms.push_back(milliseconds(start, chosen));
    row.lut->map_ms.push_back(milliseconds(chosen, mapped));
    tell(1);
    return true;
  };
  const auto repeats = static_cast<std::size_t>(options.repeats);
  const auto runs_of = [&](std::size_t i) {
    return affordable_runs(part.rows[i].ms.front(), part.rows.front().ms.front(), repeats);
  };
  if (!Rounds(settings.size(), repeats)(run, runs_of)) return std::nullopt;
  settle(part);
  return part;
}

}  // namespace sir::cli
