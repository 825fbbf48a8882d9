#include "viewer/method.h"

namespace sir::viewer {

std::string_view name(Method method) {
  switch (method) {
    case Method::true_colour: return "true colour";
    case Method::lut_file: return "LUT file";
    case Method::rgb_frequency: return "frequency in rgb";
    case Method::rgb_median: return "median in rgb";
    case Method::hsv_frequency: return "frequency in hsv";
    case Method::hsv_median: return "median in hsv";
    case Method::best: return "best";
  }
  return "";
}

}  // namespace sir::viewer
