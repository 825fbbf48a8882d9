// What the ten times of Table 4.1 say about the work behind them (thesis 4.4), in words.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "quant/clock_model.h"
#include "tracer/planes.h"

namespace sir::cli {

/// An image, and the seconds that the thesis needed for its LUT.
struct ClockImage {
  std::string title;
  Planes planes;
  double rgb_seconds = 0, hsv_seconds = 0;
};

/// One way of reading what the thesis leaves open, and the work it takes: two samples an
/// image, RGB before HSV.
struct ClockReading {
  std::string split;    ///< the order in which boxes are split
  bool shrink = false;  ///< boxes are shrunk to the colours present
  std::vector<quant::ClockSample> samples;
};

/// Walks the boxes of each image in the three orders of splitting, shrunk and not.
std::vector<ClockReading> clock_readings(std::span<const ClockImage> images);

/// The one with boxes that are shrunk whose fit is best. Throws std::invalid_argument where there
/// is none; as quant::fit_clock() does.
const ClockReading& best_reading(std::span<const ClockReading> readings);

/// The clock fitted to each reading, and to the counts alone; the reading that fits best among
/// the shrunk ones with its residuals; and what that proves and what it does not. Throws as
/// quant::fit_clock() does; std::invalid_argument where no reading is shrunk.
std::string clock_text(std::span<const ClockReading> readings);

}  // namespace sir::cli
