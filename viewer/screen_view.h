// Images on the MA120, one at a time, and what a person does to them: the
// window's contents without the window (thesis 3.5).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "eltek/bus.h"
#include "eltek/display_driver.h"
#include "eltek/ma120.h"
#include "quant/index_set.h"
#include "quant/lut.h"

namespace sir::viewer {

/// An image that is ready for the monitor.
struct ShownImage {
  std::filesystem::path base;  ///< base name; names screenshots too
  std::string lut_name;        ///< for the title: a file, or how it was chosen
  ImageSize size;
  std::vector<std::uint8_t> indices;  ///< one a pixel, rows from the top
  quant::Lut lut;
  quant::IndexSet reserved{};  ///< entries that the screen around the image may not take
};

/// One MA120 with the images that it can show. Switching runs the display
/// program again, with that image's own LUT; the planes that are switched off
/// stay off. For a LUT of another DAC that one is fitted first. All that is done
/// to the machine goes through its bus.
class ScreenView {
 public:
  /// Shows the first image. `image_area_only`: what is seen and saved is the
  /// image's area, and an image larger than the screen is cut to its centre;
  /// without it such an image is refused (FileError). There must be an image,
  /// else std::invalid_argument. A `listener`, if any, hears all that passes on
  /// the bus from power-on, and outlives the view.
  ScreenView(std::vector<ShownImage> images, bool image_area_only,
             eltek::BusListener* listener = nullptr);
  ScreenView(const ScreenView&) = delete;
  ScreenView& operator=(const ScreenView&) = delete;

  /// The next and the previous image, round in a circle.
  void next();
  void previous();

  /// Lets plane 0..7 through to the LUT, or no longer (pixel mask).
  void toggle_plane(int plane);
  void all_planes();

  const ShownImage& image() const { return images_[current_]; }
  std::uint8_t planes() const { return planes_; }

  /// What is seen: the whole screen or the image's area.
  ImageSize picture_size() const { return area_.size; }
  eltek::Screen picture() const;
  eltek::IndexedScreen capture() const;

  /// Image, its LUT, the DAC where it is not the MA120's, its number among several, the planes
  /// where some are off.
  std::string title() const;

  /// Writes capture() as an indexed PNG to FOLDER/NAME-screen.png, or
  /// -screen-2, -screen-3 ...: a file that exists is left alone. Returns the
  /// file's name. Throws FileError.
  std::filesystem::path save_capture(const std::filesystem::path& folder) const;

 private:
  void show(std::size_t number);

  std::vector<ShownImage> images_;
  eltek::Oversize oversize_;
  std::size_t current_ = 0;
  std::uint8_t planes_ = 0xFF;
  eltek::Ma120 monitor_;
  eltek::Bus bus_{monitor_};
  eltek::Area area_;
};

}  // namespace sir::viewer
