#include "viewer/letterbox.h"

#include <algorithm>

namespace sir::viewer {

int largest_multiple(ImageSize window, ImageSize picture) {
  const int fitting = std::min(window.width / std::max(picture.width, 1),
                               window.height / std::max(picture.height, 1));
  return std::clamp(fitting, 1, kMaxMultiple);
}

Letterbox centre(ImageSize window, ImageSize picture, int multiple) {
  const int width = picture.width * multiple;
  const int height = picture.height * multiple;
  return {(window.width - width) / 2, (window.height - height) / 2, width, height};
}

}  // namespace sir::viewer
