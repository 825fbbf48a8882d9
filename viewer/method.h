// How the colours on the screen were chosen, as the viewer's keys name it (thesis 3.4).
#pragma once

#include <array>
#include <string_view>

namespace sir::viewer {

enum class Method {
  true_colour,    ///< no LUT at all: the reference, which the MA120 could not show
  lut_file,       ///< the LUT of a file: --lut, else BASE.LUT
  rgb_frequency,  ///< the thesis's four
  rgb_median,
  hsv_frequency,
  hsv_median,
  best  ///< quant/best.h
};

inline constexpr std::array kMethods{
    Method::true_colour,   Method::lut_file,   Method::rgb_frequency, Method::rgb_median,
    Method::hsv_frequency, Method::hsv_median, Method::best};

/// For titles and lists: "true colour", "LUT file", "frequency in rgb", "median in hsv", "best" ...
std::string_view name(Method method);

}  // namespace sir::viewer
