// The tracer's settings on the price list (thesis 2.4, 3.3).
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "cli/cost/knob.h"
#include "tracer/render.h"

namespace sir::cli {

/// A setting of the tracer, with its words (see CostRow).
struct TracerSetting {
  std::optional<Knob> knob;  ///< none: the default
  std::string name, subject, family;
  double at = 0;
  RenderOptions options;
  int preview_block = 0;  ///< 0: the whole picture
  double weight = 1;      ///< guess of its time, in the default's

  /// Whether it sends one ray through the centre of each pixel.
  bool one_ray() const;
  /// Whether it differs from the default in how it calculates alone.
  bool only_calculates_otherwise() const;
};

/// Greatest depth of the list.
inline constexpr int kGreatestDepth = 10;

/// The default, then each knob's other positions, then useful combinations; of
/// the knobs wanted.
std::vector<TracerSetting> tracer_settings(const KnobSet& only);

/// The most accurate setting: the most precise numbers, the robust formulas, the
/// greatest depth, nothing cut off; one ray a pixel.
TracerSetting true_points();

/// The same with `samples` random rays a pixel, of a seed that no row has.
TracerSetting true_picture(int samples);

/// Another such picture in double, of a third seed: how far it is from the true one is
/// the noise of both.
TracerSetting another_picture(int samples);

/// The default in the most precise numbers.
TracerSetting true_default();

/// What the truth is, in words.
std::string truth_in_words(int samples);

/// Renders at a size with a number of threads; `progress` as in render().
RenderResult render_setting(const Scene& scene, const TracerSetting& setting, ImageSize size,
                            int threads, std::stop_token stop,
                            const std::function<void(double)>& progress = {});

}  // namespace sir::cli
