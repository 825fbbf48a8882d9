// The colours of images as weighted points: what the method `best` chooses entries for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "quant/colour_measure.h"
#include "tracer/planes.h"

namespace sir::quant {

/// A colour, and how much it counts.
struct WeightedColour {
  Rgb8 colour;
  double weight = 0;  ///< above 0
};

/// A colour, or a few neighbours as one, for the choice of entries.
struct ColourPoint {
  glm::vec3 at{};     ///< ColourMeasure::point_of, their mean
  Form form;          ///< ColourMeasure::form_of
  glm::vec3 bytes{};  ///< their mean
  float weight = 0;
};

/// The colours as one point, of their mean and with the form there; at least one colour.
ColourPoint point_of(std::span<const WeightedColour> colours, ColourMeasure& measure);

struct ColourPoints {
  std::vector<ColourPoint> all;
  double scatter = 0;  ///< sum of the colours' weights times differences from their points
};

/// The different colours of one or more images, in the order of a Morton curve (bits of r, g, b
/// in turn, high ones first), so that neighbours in a cube of side 2^k stand together.
class WeightedColours {
 public:
  /// Counts every pixel as 1, or as importance[pixel] / 255 where there is an importance; pixels
  /// of importance 0 do not count. Throws std::invalid_argument for an importance of another
  /// number of pixels.
  void add(const Planes& image, std::span<const std::uint8_t> importance = {});

  const std::vector<WeightedColour>& all() const { return colours_; }

  /// At most `limit` points: each colour by itself, or the colours of a cube of 2, 4, 8... levels
  /// a side as one.
  ColourPoints points(ColourMeasure& measure, std::size_t limit) const;

 private:
  std::vector<WeightedColour> colours_;
};

}  // namespace sir::quant
