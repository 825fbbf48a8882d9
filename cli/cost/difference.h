// How far a picture is from a truer one.
#pragma once

#include <cstddef>
#include <optional>

#include "tracer/planes.h"

namespace sir::cli {

struct Difference {
  std::optional<double> psnr;  ///< decibels; none for equal pictures
  int largest = 0;             ///< greatest difference of two bytes
  double de_mean = 0;          ///< mean CIEDE2000
  std::size_t pixels = 0;      ///< that are not the same
};

/// Throws std::invalid_argument for pictures of different sizes or without pixels.
Difference difference_between(const Planes& truth, const Planes& picture);

/// The pixels that are not the same, alone.
std::size_t pixels_changed(const Planes& a, const Planes& b);

/// The PSNR as a number that can be compared: infinite for equal pictures.
double comparable(const std::optional<double>& psnr);

}  // namespace sir::cli
