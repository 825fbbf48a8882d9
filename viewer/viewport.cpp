#include "viewer/viewport.h"

#include <algorithm>

namespace sir::viewer {
namespace {

// How far a picture may be moved from its centred place, either way.
int clamp_pan(int pan, int centred, int length, int window) {
  if (length <= window) return 0;
  return std::clamp(pan, window - length - centred, -centred);
}

int floor_div(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

}  // namespace

void Viewport::set_window(ImageSize window) {
  window_ = window;
  pan(0, 0);
}

void Viewport::set_picture(ImageSize picture) {
  picture_ = picture;
  pan(0, 0);
}

void Viewport::fit() {
  chosen_ = 0;
  pan_ = {};
}

int Viewport::multiple() const {
  return chosen_ > 0 ? chosen_ : largest_multiple(window_, picture_);
}

void Viewport::set_multiple(int multiple, std::optional<Place> anchor) {
  const Place at = anchor.value_or(Place{window_.width / 2, window_.height / 2});
  const int before = this->multiple();
  const Letterbox old = box();
  chosen_ = std::clamp(multiple, 1, kMaxMultiple);
  const Letterbox centred = centre(window_, picture_, chosen_);
  const auto moved = [&](int place, int corner) {
    return place - floor_div((place - corner) * chosen_, before);
  };
  pan_ = {moved(at.x, old.x) - centred.x, moved(at.y, old.y) - centred.y};
  pan(0, 0);
}

void Viewport::pan(int right, int down) {
  const Letterbox centred = centre(window_, picture_, multiple());
  pan_.x = clamp_pan(pan_.x + right, centred.x, centred.width, window_.width);
  pan_.y = clamp_pan(pan_.y + down, centred.y, centred.height, window_.height);
}

void Viewport::reveal(Place pixel) {
  const int m = multiple();
  const Letterbox now = box();
  const auto needed = [m](int corner, int place, int window) {
    const int first = corner + place * m;
    if (first < 0) return -first;
    return std::min(0, window - (first + m));
  };
  pan(needed(now.x, pixel.x, window_.width), needed(now.y, pixel.y, window_.height));
}

Letterbox Viewport::box() const {
  Letterbox box = centre(window_, picture_, multiple());
  box.x += pan_.x;
  box.y += pan_.y;
  return box;
}

std::optional<Place> Viewport::pixel_at(Place window) const {
  if (window.x < 0 || window.y < 0 || window.x >= window_.width || window.y >= window_.height)
    return std::nullopt;
  const Letterbox now = box();
  const Place pixel{floor_div(window.x - now.x, multiple()),
                    floor_div(window.y - now.y, multiple())};
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= picture_.width || pixel.y >= picture_.height)
    return std::nullopt;
  return pixel;
}

Letterbox Viewport::visible() const {
  const Letterbox now = box();
  const int m = multiple();
  const auto first = [m](int corner) { return std::max(0, floor_div(-corner, m)); };
  const auto end = [m](int corner, int window, int length) {
    return std::clamp(floor_div(window - corner + m - 1, m), 0, length);
  };
  const Place from{first(now.x), first(now.y)};
  const Place to{end(now.x, window_.width, picture_.width),
                 end(now.y, window_.height, picture_.height)};
  return {from.x, from.y, std::max(0, to.x - from.x), std::max(0, to.y - from.y)};
}

}  // namespace sir::viewer
