// Do a few constants explain the ten times of Table 4.1 (thesis 4.4)? Least squares of the
// times on the elementary work that choosing a LUT takes (quant/thesis_work.h).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "quant/choose.h"
#include "quant/thesis_work.h"

namespace sir::quant {

/// How much of each of three kinds of work a task takes.
using WorkRow = std::array<double, 3>;

/// The x >= 0 that makes sum over i of (rows[i] . x - y[i])^2 least, exactly: each of the 8
/// sets of constants that are not zero is tried. Where several x are equally good, one of them
/// with the fewest constants. Throws std::invalid_argument where the lengths differ.
std::array<double, 3> least_squares_nonnegative(std::span<const WorkRow> rows,
                                                std::span<const double> y);

/// One time that was measured, and the work that was done in it.
struct ClockSample {
  std::string image;  ///< its name; samples of one image are left out together
  Space space = Space::rgb;
  ThesisWork work;
  std::size_t colours = 0;  ///< occupied cells of the space's grid
  double measured_seconds = 0;
};

struct ClockFit {
  std::array<double, 3> seconds_per{};  ///< pixel read, conversion, cell visited (or colour); >= 0
  std::vector<double> predicted;        ///< seconds, a sample each
  double r2 = 0;                   ///< 1 - squared residuals / squared deviations from the mean
  double leave_one_image_out = 0;  ///< RMS seconds, each image predicted from the others alone
  bool calice_rgb_faster = false;  ///< predicted for the image CALICE (in any case of letters)
};

/// Fits seconds per pixel read, per conversion and per cell visited. Throws
/// std::invalid_argument for fewer than two images, or times that are all the same.
ClockFit fit_clock(std::span<const ClockSample> samples);

/// Fits seconds per pixel read, per conversion and per colour: by counts alone.
ClockFit fit_counts(std::span<const ClockSample> samples);

/// The images whose choice in RGB takes less time than in HSV, in the samples' order;
/// `seconds` has a time for each sample.
std::vector<std::string> faster_in_rgb(std::span<const ClockSample> samples,
                                       std::span<const double> seconds);

}  // namespace sir::quant
