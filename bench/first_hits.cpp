#include "bench/first_hits.h"

namespace sir::bench {

template <typename T>
std::vector<RayCena<T>> primary_rays(const Model<T>& model, int side) {
  std::vector<RayCena<T>> rays;
  rays.reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) rays.push_back(model.camera.primary_ray(i, j, {side, side}));
  return rays;
}

template <typename T>
void find_first_hits(Classifier<T>& classifier, const std::vector<RayCena<T>>& rays,
                     std::vector<T>& t) {
  t.resize(rays.size());
  Boundary<T> boundary;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    classifier.begin(rays[i]);
    t[i] = classifier.next(boundary) ? boundary.t : kNothing<T>;
  }
}

template std::vector<RayCena<float>> primary_rays(const Model<float>&, int);
template std::vector<RayCena<double>> primary_rays(const Model<double>&, int);
template void find_first_hits(Classifier<float>&, const std::vector<RayCena<float>>&,
                              std::vector<float>&);
template void find_first_hits(Classifier<double>&, const std::vector<RayCena<double>>&,
                              std::vector<double>&);

}  // namespace sir::bench
