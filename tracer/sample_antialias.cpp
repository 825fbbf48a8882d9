#include "tracer/sample_antialias.h"

#include <chrono>
#include <stdexcept>

#include "tracer/processor_time.h"
#include "tracer/sample_adaptive.h"
#include "tracer/sample_random.h"

namespace sir {

bool antialias(const RenderOptions& options, PointSampler& sampler,
               const std::function<void(double)>& progress, const std::stop_token& stop,
               RenderResult& result) {
  if (!options.antialias.valid())
    throw std::invalid_argument("an option of antialiasing is out of its range");
  const Region region = region_or_all(options.region, options.size);
  bool complete = false;
  if (options.antialias.mode == Antialias::adaptive) {
    complete = sample_adaptive(region, options.antialias, sampler.source(progress, stop),
                               result.planes, result.antialias);
  } else {
    PixelKeeping keeping;
    if (options.keeper)
      keeping = {options.keeper, sampler.keep_no_more(), [&] { return sampler.counts(); }};
    complete = sample_random(region, options.antialias, sampler.source(progress, stop),
                             result.planes, result.antialias, keeping);
  }
  // Levels that nothing called for are not reported.
  if (complete && progress) progress(1);
  return complete;
}

RenderResult render_antialiased(const Scene& scene, const RenderOptions& options,
                                const std::function<void(double)>& progress, std::stop_token stop) {
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::duration time) {
    return std::chrono::duration<double>(time).count();
  };
  RenderResult result;
  const auto start = Clock::now();
  PointSampler sampler(scene, options);
  result.effects = sampler.effects();
  result.prepare_seconds = seconds(Clock::now() - start);
  const auto traced = Clock::now();
  const double processor = processor_seconds();
  result.complete = antialias(options, sampler, progress, stop, result);
  result.counts = sampler.counts();
  result.trace_seconds = seconds(Clock::now() - traced);
  result.processor_seconds = processor_seconds() - processor;
  return result;
}

}  // namespace sir
