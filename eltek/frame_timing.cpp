#include "eltek/frame_timing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sir::eltek {

int FrameTiming::line_at(double seconds) const {
  if (!std::isfinite(seconds) || seconds < 0)
    throw std::invalid_argument("a time before the first frame, or none at all");
  const double within = std::fmod(seconds, frame_seconds());
  return std::min(static_cast<int>(within / line_seconds()), lines - 1);
}

}  // namespace sir::eltek
