// One MA120 with a picture on it: a place in the laboratory where the display program runs
// (thesis 3.5).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "eltek/bus.h"
#include "eltek/crt.h"
#include "eltek/display_driver.h"
#include "eltek/ma120.h"
#include "viewer/argb.h"
#include "viewer/frame.h"
#include "viewer/rendition.h"
#include "viewer/viewport.h"

namespace sir::viewer {

/// A word for each index in the MA120's memory.
using IndexWords = std::array<Argb, 256>;

/// Shows one picture after another, each with its own LUT and through the DAC that it is for.
class Station {
 public:
  /// `image_area_only`: what is seen and captured is the image's area, and an image larger than
  /// the screen is cut to its centre; without it such an image is refused.
  explicit Station(bool image_area_only = false) : image_area_only_(image_area_only) {}
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;

  /// Tells the listener of all that happens on the bus from now on; it must outlive the station.
  void add_listener(eltek::BusListener& listener) { bus_.add_listener(listener); }

  /// Runs the display program. The pixel mask stays as it was. Throws FileError, with both sizes,
  /// for an image that does not fit; the screen then stays as it was.
  void show(const std::string& name, ImageSize size, const Rendition& rendition);

  /// Lets the planes whose bit is 1 through to the LUT (pixel mask).
  void set_planes(std::uint8_t mask);
  std::uint8_t planes() const { return planes_; }

  /// As the constructor's; show() must follow.
  void set_image_area_only(bool only) { image_area_only_ = only; }
  bool image_area_only() const { return image_area_only_; }

  /// What is seen of the screen: all of it, or the image's area.
  const eltek::Area& seen_area() const { return seen_area_; }

  /// Where the image lies on the screen, and which part of it.
  const eltek::Placement& placement() const { return placement_; }

  /// The image's pixel under a pixel of what is seen, and the other way round; none beside it.
  std::optional<Place> image_pixel(Place seen) const;
  std::optional<Place> seen_pixel(Place image) const;

  /// What each index in memory is seen as, past mask, LUT, DAC and blanking, on the ideal monitor
  /// or through a tube, whose colours alone count here (Crt::palette).
  IndexWords seen_words(const eltek::Crt* crt = nullptr) const;

  /// The index in memory of each pixel reaches the LUT under this mask.
  std::uint8_t mask() const { return monitor_.lut_ports.pixel_mask(); }

  /// Scans out some columns of the area that is seen, by such words, into a frame of its size.
  void scan_out(Frame& frame, const IndexWords& words, const Columns& columns) const;

  /// The same before the LUT, for captures and maps.
  eltek::IndexedScreen capture() const { return crop(monitor_.capture(), seen_area_); }

  const quant::DacBits& dac() const { return monitor_.dac(); }

 private:
  bool image_area_only_;
  std::uint8_t planes_ = 0xFF;
  eltek::Ma120 monitor_;
  eltek::Bus bus_{monitor_};
  eltek::Area seen_area_{0, 0, eltek::Ma120::kSize};
  eltek::Placement placement_{};
};

}  // namespace sir::viewer
