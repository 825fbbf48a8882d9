#include "viewer/side.h"

#include <utility>

#include "tracer/error.h"

namespace sir::viewer {

Method Side::method_for(const Picture& picture, const RenditionOptions& options) const {
  if (chosen_) return *chosen_;
  return lut_file(picture.base, options) ? Method::lut_file : Method::hsv_median;
}

bool Side::update(Workshop& workshop, std::size_t number, const RenditionOptions& options) {
  const auto latest = workshop.state(number).picture;
  if (!latest) {
    // What was said of the picture before is not of this one.
    waiting_ = false;
    error_.clear();
    return false;
  }
  const Method wanted = method_for(*latest, options);
  // True colour lies over the screen of some LUT, which the border around the image still shows.
  Method on_screen = wanted;
  if (wanted == Method::true_colour) {
    on_screen = rendition_ ? rendition_->method : Method::hsv_median;
    // This picture may have no LUT file where the one before had.
    if (!workshop.rendition_error(number, on_screen).empty()) on_screen = Method::hsv_median;
  }
  const Workshop::Shown shown = workshop.shown(number, on_screen);
  std::string error = workshop.rendition_error(number, on_screen);
  waiting_ = !shown.current && error.empty();
  if (!shown.rendition) {
    const bool news = error != error_;
    error_ = std::move(error);
    return news;
  }
  const bool same_screen = shown.rendition == latest_.rendition;
  const bool changed = !same_screen || shown.picture != latest_.picture || wanted != latest_method_;
  if (!changed) {
    if (fits_) error_ = std::move(error);
    return false;
  }
  if (fits_ || !same_screen) error_ = std::move(error);
  latest_ = shown;
  latest_method_ = wanted;
  if (!same_screen) show_again();
  else if (fits_) take_latest();
  return true;
}

void Side::show_again() {
  if (!latest_.rendition) return;
  const Picture& picture = *latest_.picture;
  try {
    station_.show(picture.input.string(), picture.planes.size, *latest_.rendition);
    fits_ = true;
    take_latest();
  } catch (const FileError& error) {
    error_ = error.what();
    fits_ = false;
  }
}

void Side::take_latest() {
  picture_ = latest_.picture;
  rendition_ = latest_.rendition;
  shown_method_ = latest_method_;
}

}  // namespace sir::viewer
