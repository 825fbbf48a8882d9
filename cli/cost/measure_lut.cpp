#include "cli/cost/measure.h"

#include <algorithm>

#include "quant/blurred_difference.h"
#include "quant/metrics.h"
#include "quant/shown_through.h"
#include "tracer/processor_time.h"

namespace sir::cli {
namespace {

constexpr double kJudging = 75;  // takes about so many runs of the default

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
  row.lut->de_blurred = quant::blurred_difference(image, shown);
}

// For the progress: all that will be done, in runs of the default.
double expected_work(const std::vector<LutSetting>& settings, std::size_t repeats) {
  double work = 0;
  for (const LutSetting& setting : settings) {
    const std::size_t runs = affordable_runs(setting.weight, 1, repeats);
    work += kJudging + setting.weight * static_cast<double>(1 + runs);
  }
  return work;
}

}  // namespace

std::optional<CostPart> measure_lut(const Planes& image, const std::vector<LutSetting>& settings,
                                    const MeasureOptions& options) {
  CostPart part;
  for (const LutSetting& setting : settings) part.rows.push_back(row_of(setting));
  const auto repeats = static_cast<std::size_t>(options.repeats);
  const double expected = expected_work(settings, repeats);
  double done = 0;
  const auto tell = [&](double more) {
    done += more;
    if (options.progress) options.progress(std::min(1.0, done / expected));
  };

  Planes of_default;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (options.stop.stop_requested()) return std::nullopt;
    const ChosenLut chosen = chosen_by(settings[i].choice, image);
    const Planes shown =
        quant::as_seen(image.size, mapped_by(settings[i].mapping, image, chosen.lut), chosen.lut);
    part.rows[i].lut->colours = chosen.colours;
    part.rows[i].lut->entries = chosen.entries;
    judge(image, shown, part.rows[i]);
    if (i == 0) of_default = shown;
    part.rows[i].changed = pixels_changed(of_default, shown);
    tell(kJudging + settings[i].weight);
  }

  const auto run = [&](std::size_t i) {
    if (options.stop.stop_requested()) return false;
    const double start = processor_seconds();
    const quant::Lut lut = chosen_by(settings[i].choice, image).lut;
    const double chosen = processor_seconds();
    const auto indices = mapped_by(settings[i].mapping, image, lut);
    const double mapped = processor_seconds();
    CostRow& row = part.rows[i];
    row.ms.push_back(milliseconds(start, mapped));
    row.lut->choose_ms.push_back(milliseconds(start, chosen));
    row.lut->map_ms.push_back(milliseconds(chosen, mapped));
    tell(settings[i].weight);
    return true;
  };
  const auto runs_of = [&](std::size_t i) {
    return affordable_runs(part.rows[i].ms.front(), part.rows.front().ms.front(), repeats);
  };
  if (!Rounds(settings.size(), repeats)(run, runs_of)) return std::nullopt;
  settle(part);
  return part;
}

}  // namespace sir::cli
