// The bytes that primary rays give (SIR's loop body, thesis 3.3), by whichever way
// serves: packets, or one ray after another.
#pragma once

#include <memory>
#include <span>

#include "tracer/trace.h"
#include "tracer/wavefront.h"

namespace sir {

/// One for each thread. The model must outlive it. The bytes are the same either way.
template <typename T>
class PixelTracer {
 public:
  /// Packets serve Engine::gates where the model's solid is laid out for them; all
  /// else is traced plainly.
  PixelTracer(const Model<T>& model, const TraceOptions& options);

  /// The bytes of primary rays, as many as there are places in `bytes`. Neighbours
  /// together are faster than strangers.
  void pixels(std::span<const RayCena<T>> primary, std::span<Rgb8> bytes);

  RayCounts counts() const;

 private:
  struct Plain {
    Tracer<T> tracer;
    void pixels(std::span<const RayCena<T>> primary, std::span<Rgb8> bytes) {
      for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = tracer.pixel(primary[i]);
    }
    RayCounts counts() const { return tracer.counts(); }
  };
  static constexpr bool kInPackets = !std::is_same_v<T, long double>;
  using Fast = std::conditional_t<kInPackets, Wavefront<T>, Plain>;

  std::unique_ptr<Fast> fast_;    // or
  std::unique_ptr<Plain> plain_;  // the one that is not null
};

}  // namespace sir
