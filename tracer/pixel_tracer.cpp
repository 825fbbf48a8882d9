#include "tracer/pixel_tracer.h"

namespace sir {

template <typename T>
PixelTracer<T>::PixelTracer(const Model<T>& model, const TraceOptions& options) {
  if constexpr (kInPackets)
    if (options.engine == Engine::gates && options.packets && model.laid_out)
      fast_ = std::make_unique<Fast>(model, options);
  if (!fast_) plain_ = std::make_unique<Plain>(Tracer<T>(model, options));
}

template <typename T>
void PixelTracer<T>::pixels(std::span<const RayCena<T>> primary, std::span<Rgb8> bytes) {
  if (fast_) fast_->pixels(primary, bytes);
  else plain_->pixels(primary, bytes);
}

template <typename T>
RayCounts PixelTracer<T>::counts() const {
  return fast_ ? fast_->counts() : plain_->counts();
}

template class PixelTracer<float>;
template class PixelTracer<double>;
template class PixelTracer<long double>;

}  // namespace sir
