#include "tracer/camera.h"

#include "tracer/numeric.h"

namespace sir {

template <typename T>
Camera<T>::Camera(const CameraFile& file)
    : window_(file.window), focal_(static_cast<T>(file.focal)), parallel_(file.parallel) {
  using Wider = AtLeastDouble<T>;
  using Vec = glm::vec<3, Wider>;
  const Vec n = glm::normalize(Vec(scaled_near_one(file.normal)));
  const Vec right = glm::normalize(glm::cross(n, Vec(scaled_near_one(file.up))));
  const glm::mat<3, 3, Wider> axes(right, glm::cross(right, n), n);
  obs_cena_.linear = glm::mat<3, 3, T>(axes);
  obs_cena_.numerators = glm::mat<3, 3, T>(glm::transpose(axes));
  obs_cena_.translation = glm::vec<3, T>(Vec(file.target) - Wider(file.distance) * n);
}

template <typename T>
RayObs<T> Camera<T>::ray_obs_through(double x, double y, ImageSize size) const {
  // Both differences are exact where x and y are multiples of 1/64, as those of pixels'
  // centres and of antialiasing's lattice are.
  const T xp = window_.x * static_cast<T>(2 * x - size.width) / T(2 * size.width);
  const T yp = window_.y * static_cast<T>(size.height - 2 * y) / T(2 * size.height);
  if (parallel_) return {{{xp, yp, 0}}, {{0, 0, 1}}};
  return {{{xp, yp, 0}}, {{xp, yp, focal_}}};
}

template <typename T>
RayObs<T> Camera<T>::primary_ray_obs(int i, int j, ImageSize size) const {
  return ray_obs_through(i + 0.5, j + 0.5, size);
}

template <typename T>
RayCena<T> Camera<T>::ray_through(double x, double y, ImageSize size) const {
  const RayObs<T> ray = ray_obs_through(x, y, size);
  return {obs_cena_.apply(ray.origin), obs_cena_.apply(ray.direction)};
}

template <typename T>
RayCena<T> Camera<T>::primary_ray(int i, int j, ImageSize size) const {
  return ray_through(i + 0.5, j + 0.5, size);
}

template class Camera<float>;
template class Camera<double>;
template class Camera<long double>;

}  // namespace sir
