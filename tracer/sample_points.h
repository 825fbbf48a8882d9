// Tracing any points of the screen: what all that sends more, or fewer, rays than
// one a pixel is made of (thesis 2.4.5, 2.5.1).
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stop_token>

#include "tracer/planes.h"
#include "tracer/ray_counts.h"
#include "tracer/render.h"

namespace sir {

/// In pixels from the image's top left corner, x to the right, y down; the centre
/// of the pixel in column i and row j is at (i + 1/2, j + 1/2).
struct ScreenPoint {
  double x = 0, y = 0;
  friend auto operator<=>(const ScreenPoint&, const ScreenPoint&) = default;
};

/// A part of the whole work, in shares of it.
struct Share {
  double from = 0, to = 1;
};

/// Gives the sample of each point, in order; they bring the work from share.from to
/// share.to. False where it was stopped: the colours are then worth nothing.
using SampleSource = std::function<bool(std::span<const ScreenPoint> points,
                                        std::span<Rgb8> colours, const Share& share)>;

/// A scene made ready for tracing points of its image, in the options' precision
/// and with their threads. It keeps what each thread needs between the calls.
class PointSampler {
 public:
  /// Takes `size`, `threads`, `precision` and `trace` of the options; what it traces is
  /// not antialiased.
  PointSampler(const Scene& scene, const RenderOptions& options);
  ~PointSampler();
  PointSampler(PointSampler&&) noexcept;
  PointSampler& operator=(PointSampler&&) noexcept;

  /// The samples of the points, kept as a stage of their own by the options' keeper; colours.size()
  /// == points.size(). The same for any number of threads. `progress`, if given, is called as by
  /// render(). A stop request takes effect within 256 points of each thread; false then.
  bool trace(std::span<const ScreenPoint> points, std::span<Rgb8> colours,
             const std::function<void(double)>& progress = {}, const std::stop_token& stop = {});

  /// trace() as a source, its progress in shares of the whole work. The sampler must
  /// outlive it.
  SampleSource source(std::function<void(double)> progress, std::stop_token stop);

  /// Ends the keeping of samples, for who keeps what is made of them; the number of the stage
  /// that follows.
  std::uint32_t keep_no_more();

  RayCounts counts() const;          ///< of all calls so far, with those of tiles taken
  const EffectSet& effects() const;  ///< those that the scene and the options call for

 private:
  class Work;
  template <typename T>
  class WorkIn;
  std::unique_ptr<Work> work_;
};

}  // namespace sir
