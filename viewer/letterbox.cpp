#include "viewer/letterbox.h"

#include <algorithm>
#include <array>

namespace sir::viewer {

int largest_multiple(ImageSize window, ImageSize picture) {
  const int fitting = std::min(window.width / std::max(picture.width, 1),
                               window.height / std::max(picture.height, 1));
  return std::clamp(fitting, 1, kMaxMultiple);
}

namespace {
constexpr std::array kMultiples{1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 40, 48, kMaxMultiple};
}

int next_multiple(int multiple) {
  const auto next = std::upper_bound(kMultiples.begin(), kMultiples.end(), multiple);
  return next == kMultiples.end() ? kMaxMultiple : *next;
}

int previous_multiple(int multiple) {
  const auto here = std::lower_bound(kMultiples.begin(), kMultiples.end(), multiple);
  return here == kMultiples.begin() ? kMultiples.front() : *(here - 1);
}

Letterbox centre(ImageSize window, ImageSize picture, int multiple) {
  const int width = picture.width * multiple;
  const int height = picture.height * multiple;
  return {(window.width - width) / 2, (window.height - height) / 2, width, height};
}

}  // namespace sir::viewer
