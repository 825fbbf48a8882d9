#include <algorithm>
#include <numeric>

#include "cli/cost/measure.h"
#include "quant/psnr.h"

namespace sir::cli {
namespace {

double milliseconds(const RenderResult& result) {
  return (result.prepare_seconds + result.trace_seconds) * 1e3;
}

// The pictures that rows are compared with.
struct Truth {
  Planes points, picture;
  std::optional<Planes> calculated;  // the default, most precisely
};

class Measurement {
 public:
  Measurement(const Scene& scene, ImageSize size, const std::vector<TracerSetting>& settings,
              const MeasureOptions& options)
      : scene_(scene), size_(size), settings_(settings), options_(options) {
    const double a_round = std::accumulate(
        settings.begin(), settings.end(), 0.0,
        [](double sum, const TracerSetting& setting) { return sum + setting.weight; });
    expected_ = a_round + truth_weight(options.truth_samples) + dear_rounds();
  }

  // False where it was stopped.
  bool find_truth() {
    const auto points = picture_of(true_points());
    if (!points) return false;
    truth_.points = *points;
    const auto picture = picture_of(true_picture(options_.truth_samples));
    if (!picture) return false;
    truth_.picture = *picture;
    const auto other = picture_of(another_picture(options_.truth_samples));
    if (!other) return false;
    noise_ = quant::psnr(*picture, *other);
    const bool rounds = std::any_of(
        settings_.begin() + 1, settings_.end(),
        [](const TracerSetting& setting) { return setting.only_calculates_otherwise(); });
    if (!rounds) return true;
    truth_.calculated = picture_of(true_default());
    return truth_.calculated.has_value();
  }

  bool run_rows() {
    // The first picture of a process also pays for memory that the others find in place.
    if (!picture_of(settings_.front())) return false;
    rows_.resize(settings_.size());
    const Rounds rounds(settings_.size(), static_cast<std::size_t>(options_.repeats));
    return rounds([&](std::size_t i) { return run_row(i); },
                  [&](std::size_t i) {
                    return affordable_runs(rows_[i].ms.front(), rows_.front().ms.front(),
                                           static_cast<std::size_t>(options_.repeats));
                  });
  }

  TracerPart part() {
    TracerPart result{{std::move(rows_), {}}, std::move(default_), noise_};
    settle(result.part);
    return result;
  }

 private:
  static double truth_weight(int samples) {
    return true_points().weight + true_default().weight + true_picture(samples).weight +
           another_picture(samples).weight;
  }

  double dear_rounds() const {
    double sum = 0;
    for (const TracerSetting& setting : settings_)
      sum +=
          setting.weight *
          static_cast<double>(
              affordable_runs(setting.weight, 1, static_cast<std::size_t>(options_.repeats)) - 1);
    return sum;
  }

  std::optional<RenderResult> rendered(const TracerSetting& setting,
                                       const std::function<void(double)>& progress = {}) {
    RenderResult result =
        render_setting(scene_, setting, size_, options_.threads, options_.stop, progress);
    if (!result.complete) return std::nullopt;
    tell(setting.weight);
    done_ += setting.weight;
    return result;
  }

  void tell(double more) const {
    if (options_.progress) options_.progress(std::min(1.0, (done_ + more) / expected_));
  }

  std::optional<Planes> picture_of(const TracerSetting& setting) {
    // These are not timed, and some take long.
    auto result = rendered(setting, [&](double share) { tell(share * setting.weight); });
    if (!result) return std::nullopt;
    return std::move(result->planes);
  }

  bool run_row(std::size_t i) {
    auto result = rendered(settings_[i]);
    if (!result) return false;
    if (rows_[i].ms.empty()) {
      if (i == 0) default_ = result->planes;  // the first of all
      judge(i, result->planes);
    }
    rows_[i].ms.push_back(milliseconds(*result));
    return true;
  }

  void judge(std::size_t i, const Planes& picture) {
    const TracerSetting& setting = settings_[i];
    CostRow& row = rows_[i];
    row.knob = setting.knob;
    row.name = setting.name;
    row.subject = setting.subject;
    row.family = setting.family;
    row.at = setting.at;
    row.picture = difference_between(truth_.picture, picture);
    if (setting.one_ray()) row.points = difference_between(truth_.points, picture);
    row.changed = pixels_changed(default_, picture);
    if (truth_.calculated && setting.only_calculates_otherwise())
      row.rounded = pixels_changed(*truth_.calculated, picture);
  }

  const Scene& scene_;
  ImageSize size_;
  const std::vector<TracerSetting>& settings_;
  const MeasureOptions& options_;
  Truth truth_;
  std::optional<double> noise_;
  std::vector<CostRow> rows_;
  Planes default_;  // the default's picture
  double done_ = 0, expected_ = 1;
};

}  // namespace

std::optional<TracerPart> measure_tracer(const Scene& scene, ImageSize size,
                                         const std::vector<TracerSetting>& settings,
                                         const MeasureOptions& options) {
  Measurement measurement(scene, size, settings, options);
  if (!measurement.find_truth() || !measurement.run_rows()) return std::nullopt;
  return measurement.part();
}

}  // namespace sir::cli
