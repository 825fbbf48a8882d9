// The camera and its primary rays (thesis 2.3.3, 3.6.2).
#pragma once

#include "tracer/frames.h"
#include "tracer/planes.h"
#include "tracer/scene.h"

namespace sir {

/// OBS_CENA and the window. SC_OBS has its origin in the screen's centre, X to
/// the right, Y up, Z into the scene.
template <typename T>
class Camera {
 public:
  explicit Camera(const CameraFile& file);

  /// The ray through the centre of the pixel in column i and row j (from the
  /// top) of an image, in SC_CENA. It starts on the screen with t = 0;
  /// perspective (Xp,Yp,0) + t (Xp,Yp,Zf), parallel (Xp,Yp,0) + t (0,0,1).
  RayCena<T> primary_ray(int i, int j, ImageSize size) const;

  /// The same in SC_OBS.
  RayObs<T> primary_ray_obs(int i, int j, ImageSize size) const;

  /// The ray through any point of the screen, in pixels from the image's top left
  /// corner; primary_ray(i, j) to the bit at (i + 1/2, j + 1/2).
  RayCena<T> ray_through(double x, double y, ImageSize size) const;

 private:
  RayObs<T> ray_obs_through(double x, double y, ImageSize size) const;

  Transform<ScObs, ScCena, T> obs_cena_;
  glm::vec<2, T> window_;
  T focal_;
  bool parallel_;
};

}  // namespace sir
