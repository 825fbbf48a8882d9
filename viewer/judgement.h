// How good what is on the screen is, in numbers and words (thesis 3.4.3 and 4).
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "quant/metrics.h"
#include "tracer/planes.h"

namespace sir::viewer {

/// A hue of the picture that is gone from the screen (quant/hue_loss.h).
struct LostHue {
  int degrees = 0;
  std::string_view name;  ///< quant::hue_name
  std::uint64_t pixels = 0;
  double lost = 0;  ///< share of them that is shown in another hue or in grey
};

struct Judgement {
  quant::ImageMetrics metrics;
  std::vector<LostHue> lost;
};

/// Takes about a tenth of a second for 640x480 pixels. After a stop request, which is looked at
/// before, between and behind its two parts, none comes back. Throws std::invalid_argument for
/// pictures of different sizes or without pixels.
std::optional<Judgement> judge(const Planes& reference, const Planes& shown,
                               std::stop_token stop = {});

/// For people: lines of at most kDescriptionWidth letters (viewer/inspection.h).
std::vector<std::string> describe(const Judgement& judgement);

}  // namespace sir::viewer
