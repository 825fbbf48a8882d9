// All that is known of one pixel: from the ray that found its colour to the code that shows it
// (thesis 2.4, 3.4, 3.5).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "eltek/display_driver.h"
#include "quant/choose.h"
#include "quant/ciede2000.h"
#include "quant/colour_measure.h"
#include "quant/entry_groups.h"
#include "quant/map_image.h"
#include "quant/provenance.h"
#include "viewer/method.h"
#include "viewer/picture.h"
#include "viewer/pixel_ray.h"
#include "viewer/rendition.h"

namespace sir::viewer {

/// An entry against a colour.
struct EntryDistance {
  std::uint8_t index = 0;
  Rgb8 seen;
  int squared = 0;        ///< D_i of the thesis's search (3.5 b): squared, of the bytes
  double difference = 0;  ///< CIEDE2000
};

/// The two entries that come nearest to a colour, none of them reserved.
struct NearestTwo {
  EntryDistance winner;
  std::optional<EntryDistance> runner_up;  ///< of another colour than the winner's, if there is one
};

/// What the LUT does to the pixel.
struct PixelShown {
  Method method = Method::hsv_median;
  std::string lut_name;
  EntryDistance entry;  ///< the one that shows it
  quant::DacCode code{};
  quant::DacBits dac;
  NearestTwo by_bytes;
  std::optional<NearestTwo> by_eye;  ///< where pixels are mapped by the eye
  bool dithered = false;             ///< the entry is not the nearest as pixels are mapped
  quant::EntryGroup group;           ///< the pixels that share the entry, this one among them
  std::uint64_t image_pixels = 0;
  std::optional<EntryDistance> nearest_other;  ///< to the entry: another colour of the LUT
  quant::ChooseOptions choice;                 ///< of `origin`
  std::optional<quant::CellOrigin> origin;     ///< of the thesis's four methods
  std::optional<EntryDistance> made;           ///< the entry made of the pixel's cell
};

/// A pixel; what is not known of it is left out.
struct Inspection {
  int column = 0, row = 0;            ///< in the image, from its upper left corner
  std::optional<eltek::Area> screen;  ///< the pixel on the MA120's screen; none: cut off
  Rgb8 true_colour;
  std::optional<PixelShown> shown;  ///< none for the true colours, which go through no LUT
  std::optional<RayFind> ray;       ///< none where there is no scene
  bool complete = true;             ///< false: the picture is a stage of a render
};

/// Answers for one picture as one rendition shows it. Making it costs about as much as choosing the
/// LUT again by the thesis's method and may be done on another thread; inspect() follows the mouse.
/// Threads may call it at once and are served one by one.
class Inspector {
 public:
  /// `rendition`: null for the true colours. `map`: how its pixels were mapped. Throws
  /// std::invalid_argument for a rendition of another number of pixels.
  Inspector(std::shared_ptr<const Picture> picture, std::shared_ptr<const Rendition> rendition,
            const quant::MapOptions& map = {});

  const Picture& picture() const { return *picture_; }
  const Rendition* rendition() const { return rendition_.get(); }

  /// Throws std::out_of_range for a pixel that does not lie within the picture.
  Inspection inspect(int column, int row);

  /// The pixels that share an entry.
  const quant::EntryGroup& group(std::uint8_t index) const { return groups_[index]; }

 private:
  PixelShown shown(std::size_t pixel);
  EntryDistance distance(Rgb8 colour, std::uint8_t index);
  NearestTwo nearest(Rgb8 colour, quant::Goal by);

  std::shared_ptr<const Picture> picture_;
  std::shared_ptr<const Rendition> rendition_;
  quant::MapOptions map_;
  std::array<quant::EntryGroup, quant::kLutEntries> groups_{};
  std::optional<quant::Provenance> provenance_;
  std::optional<PixelRay> ray_;
  std::mutex in_use_;  // of what follows, which remembers its answers, and of ray_
  quant::ColourDifference difference_;
  quant::ColourMeasure measure_{quant::Goal::perceptual};
};

/// The thesis's method that is meant; none for the others.
std::optional<quant::ChooseOptions> choice_of(Method method);

/// For people: lines of at most kDescriptionWidth letters, all of them in ASCII or Latin-1, an
/// empty line between what belongs together. A name from a file is cut where it is too long.
inline constexpr int kDescriptionWidth = 60;
std::vector<std::string> describe(const Inspection& inspection);

}  // namespace sir::viewer
