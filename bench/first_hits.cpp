#include "bench/first_hits.h"

#include <algorithm>

namespace sir::bench {

template <typename T>
std::vector<RayCena<T>> primary_rays(const Model<T>& model, int side) {
  std::vector<RayCena<T>> rays;
  rays.reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  const auto squares = [](int x0, int y0, int size, int step, const auto& visit) {
    for (int y = y0; y < y0 + size; y += step)
      for (int x = x0; x < x0 + size; x += step) visit(x, y);
  };
  squares(0, 0, side, kBatchSide, [&](int bx, int by) {
    squares(bx, by, kBatchSide, kPacketSide, [&](int px, int py) {
      squares(px, py, kPacketSide, 1, [&](int x, int y) {
        rays.push_back(model.camera.primary_ray(x, y, {side, side}));
      });
    });
  });
  return rays;
}

template <typename T>
FirstHits<T>::FirstHits(const Model<T>& model) : packets_(model.solid, *model.laid_out) {}

template <typename T>
void FirstHits<T>::find(const std::vector<RayCena<T>>& rays, std::vector<T>& t) {
  constexpr std::size_t kBatch = std::size_t{kBatchSide} * kBatchSide;
  t.resize(rays.size());
  for (std::size_t first = 0; first < rays.size(); first += kBatch) {
    stream_.clear();
    const std::size_t end = std::min(first + kBatch, rays.size());
    for (std::size_t i = first; i < end; ++i) stream_.push(rays[i]);
    const bool listed = packets_.list(stream_.all(), list_);
    for (std::size_t p = 0; p < stream_.packets(); ++p) {
      const PacketFirst<T> found = packets_.first(stream_.packet(p), listed ? &list_ : nullptr);
      const std::size_t from = first + p * kPacketLanes;
      for (std::size_t lane = 0; lane < kPacketLanes && from + lane < end; ++lane)
        t[from + lane] = found.hit >> lane & 1u ? found.boundary[lane].t : kNothing<T>;
    }
  }
}

template std::vector<RayCena<float>> primary_rays(const Model<float>&, int);
template std::vector<RayCena<double>> primary_rays(const Model<double>&, int);
template class FirstHits<float>;
template class FirstHits<double>;

}  // namespace sir::bench
