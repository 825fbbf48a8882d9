#include "tracer/sample_antialias.h"

#include <chrono>
#include <stdexcept>

#include "tracer/processor_time.h"
#include "tracer/sample_adaptive.h"
#include "tracer/sample_random.h"

namespace sir {

bool antialias(const RenderOptions& options, const SampleSource& source, RenderResult& result) {
  if (!options.antialias.valid())
    throw std::invalid_argument("an option of antialiasing is out of its range");
  const Region region = region_or_all(options.region, options.size);
  const auto sample =
      options.antialias.mode == Antialias::adaptive ? sample_adaptive : sample_random;
  return sample(region, options.antialias, source, result.planes, result.antialias);
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
  result.complete = antialias(options, sampler.source(progress, stop), result);
  // Levels that nothing called for are not reported.
  if (result.complete && progress) progress(1);
  result.counts = sampler.counts();
  result.trace_seconds = seconds(Clock::now() - traced);
  result.processor_seconds = processor_seconds() - processor;
  return result;
}

}  // namespace sir
