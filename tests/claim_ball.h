// The small coloured ball of docs/claim/ball, on which the thesis's claim is tried: "the LUT
// chosen in RGB spoiled the image, the one chosen in HSV showed it right" (thesis 4.4).
#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <vector>

#include <glm/vec3.hpp>

#include "quant/choose.h"
#include "tracer/planes.h"
#include "tracer/scene.h"

namespace sir::test {

/// What can be varied about the ball: it lies on the chequerboard at (x, z).
struct Ball {
  glm::dvec3 colour{0.1, 0.7, 0.15};  ///< ambient and diffuse coefficients
  double radius = 0.1;
  double x = -1.6, z = 0.6;  ///< SC_CENA
};

/// How far the image as seen is from the true one.
struct BallLoss {
  double ball = 0;   ///< root of the mean squared difference of bytes, in the ball's pixels
  double image = 0;  ///< the same over all pixels
  double hue = 0;    ///< share of the ball's coloured pixels seen in another hue plane, or grey
  std::vector<int> alarms;  ///< hue planes that are gone from the image (quant/hue_loss.h)
};

/// Our whitted with such a ball, rendered, and the pixels in which the ball is seen
/// directly: those whose first boundary is its own.
class BallImage {
 public:
  /// `base`: docs/claim/ball. Throws FileError.
  BallImage(const std::filesystem::path& base, const Ball& ball, ImageSize size);

  const Planes& image() const { return image_; }
  /// The hue planes in which the ball's pixels lie.
  std::set<int> hues() const;
  std::size_t pixels() const { return true_ball_.size.pixels(); }

  /// Mean CIEDE2000 of the ball's pixels in the image as `shown`.
  double ball_difference(const Planes& shown) const;

  /// With the LUT of median cut, each pixel as the nearest entry.
  BallLoss loss(quant::Space space, quant::SplitOrder order) const;

 private:
  Planes of_ball(const Planes& image) const;

  Planes image_;
  std::vector<std::size_t> ball_;
  Planes true_ball_;  // its pixels in a row
};

}  // namespace sir::test
