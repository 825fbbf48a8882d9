// One side of the screen: a picture by one method on an MA120 of its own. With a second side the
// thesis's comparison of RGB and HSV (3.4) is seen at a glance.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "viewer/station.h"
#include "viewer/workshop.h"

namespace sir::viewer {

/// What the workshop has ready is taken in by update(); until then the last picture stays.
class Side {
 public:
  explicit Side(bool image_area_only) : station_(image_area_only) {}

  /// The method for this and all other pictures; without one each takes the LUT of its file where
  /// there is one, else the median cut in HSV.
  void choose(Method method) { chosen_ = method; }
  std::optional<Method> chosen() const { return chosen_; }

  /// Asks the workshop for the picture by the method and shows what is new. Returns whether
  /// anything is. An image that does not fit the screen leaves it as it was: see error().
  bool update(Workshop& workshop, std::size_t number, const RenditionOptions& options);

  /// Runs the display program with the latest picture: after station() was told to show another
  /// area.
  void show_again();

  Station& station() { return station_; }
  const Station& station() const { return station_; }

  /// What is shown, and through which LUT: null until there is one, and what was before where the
  /// latest does not fit. In true colour the last rendition stays on the MA120, which can show no
  /// other.
  const std::shared_ptr<const Picture>& picture() const { return picture_; }
  const std::shared_ptr<const Rendition>& rendition() const { return rendition_; }
  bool true_colour() const { return shown_method_ == Method::true_colour; }
  Method shown_method() const { return shown_method_; }

  /// Why something that was asked for is not shown; empty: it is, or it will be.
  const std::string& error() const { return error_; }

  /// Whether something newer is on its way.
  bool waiting() const { return waiting_; }

  /// Whether the latest image fits the screen.
  bool fits() const { return fits_; }

 private:
  Method method_for(const Picture& picture, const RenditionOptions& options) const;
  void take_latest();

  Station station_;
  std::optional<Method> chosen_;
  Method shown_method_ = Method::hsv_median;
  Method latest_method_ = Method::hsv_median;
  Workshop::Shown latest_;  // offered to the station, which may have refused it
  std::shared_ptr<const Picture> picture_;
  std::shared_ptr<const Rendition> rendition_;
  std::string error_;
  bool waiting_ = false, fits_ = true;
};

}  // namespace sir::viewer
