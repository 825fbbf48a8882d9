// What the primary ray through a pixel meets (RAY-TRACING, thesis 2.3.6).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>

#include "tracer/model.h"
#include "tracer/scene.h"
#include "tracer/trace.h"

namespace sir::viewer {

/// The first thing on the ray, named as in the files.
struct RayFind {
  bool hit = false;  ///< false: the background; the rest means nothing then
  std::int64_t node = 0;
  std::string node_name;
  PrimitiveKind kind = PrimitiveKind::cube;
  int face = 0;
  std::int64_t surface = 0;
  std::string surface_name;
  double t = 0;  ///< in units of the ray's direction, from the screen on (contract of .CAM)
};

/// A scene made ready once, to be asked about many pixels: the same answers as the first ray of
/// trace_pixel() in double precision, without what lies behind. One thread at a time.
class PixelRay {
 public:
  PixelRay(std::shared_ptr<const Scene> scene, ImageSize size);

  RayFind find(int column, int row);

 private:
  std::shared_ptr<const Scene> scene_;
  ImageSize size_;
  std::unordered_map<std::int64_t, std::size_t> nodes_;  // their indices, by number
  std::unique_ptr<const Model<double>> model_;  // at a place of its own: the tracer refers to it
  Tracer<double> tracer_;
};

}  // namespace sir::viewer
