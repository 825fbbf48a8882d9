// A scene in the language of POV-Ray 3.7, to be rendered by another hand: the
// images are compared pixel by pixel (the thesis, chapter 4, had only the eye).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tracer/planes.h"
#include "tracer/scene.h"

namespace sir {

/// POV-Ray's tolerances are absolute: it takes no boundary nearer than 0.0001
/// (0.001 for shadows) to the ray's start, and its bounding boxes are of single
/// precision. `fit` moves and scales the scene to where this is of no
/// consequence; `keep` leaves every number as the files have it.
enum class PovScale : std::uint8_t { fit, keep };

struct PovOptions {
  std::string file = "scene.pov";  ///< its name, for the command line in the comments
  int depth_limit = 5;             ///< as TraceOptions::depth_limit; POV-Ray takes at most 256
  ImageSize size;                  ///< of the image, for the command line in the comments
  PovScale scale = PovScale::fit;
};

/// The scene file's text: ASCII but for names in comments. What POV-Ray computes
/// alike and what not is said in the comment at its head. Never recurses.
std::string pov_text(const Scene& scene, const PovOptions& options);

/// The arguments after `povray` that give an image as `sir render` does: linear
/// bytes, one ray through each pixel's centre. `scene` and `png` are names of
/// files in the working folder.
std::vector<std::string> pov_arguments(const std::string& scene, const std::string& png,
                                       ImageSize size);

}  // namespace sir
