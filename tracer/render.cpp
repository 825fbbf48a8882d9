#include "tracer/render.h"

#include <chrono>
#include <memory>
#include <stdexcept>
#include <vector>

#include "tracer/recentre.h"
#include "tracer/sample_antialias.h"
#include "tracer/trace.h"

namespace sir {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <typename T>
RenderResult render_in(const Scene& scene, const RenderOptions& options,
                       const std::function<void(double)>& progress, const std::stop_token& stop) {
  region_or_all(options.region, options.size);  // refused before any work
  const auto start = std::chrono::steady_clock::now();
  const Model<T> model(scene, options.trace.possible_effects(), options.trace.formulas);
  const double prepare_seconds = seconds_since(start);
  RenderResult result = render_model(model, options, progress, stop);
  result.prepare_seconds = prepare_seconds;
  return result;
}

template <typename T>
PixelTrace trace_pixel_in(const Scene& scene, const RenderOptions& options, int i, int j) {
  const Model<T> model(scene, options.trace.possible_effects(), options.trace.formulas);
  Tracer<T> tracer(model, options.trace);
  PixelTrace result;
  result.pixel =
      to_rgb8(tracer.radiance(model.camera.primary_ray(i, j, options.size), &result.log));
  return result;
}

}  // namespace

template <typename T>
RenderResult render_model(const Model<T>& model, const RenderOptions& options,
                          const std::function<void(double)>& progress, std::stop_token stop) {
  const Region region = region_or_all(options.region, options.size);
  RenderResult result;
  result.effects = model.effects;
  const auto traced = std::chrono::steady_clock::now();
  Planes planes(ImageSize{region.width, region.height});
  std::vector<std::shared_ptr<Tracer<T>>> tracers;
  const auto make_worker = [&]() -> TileWorker {
    tracers.push_back(std::make_shared<Tracer<T>>(model, options.trace));
    return [&, tracer = tracers.back()](const Region& tile) {
      for (int j = tile.y; j < tile.y + tile.height && !stop.stop_requested(); ++j)
        for (int i = tile.x; i < tile.x + tile.width; ++i) {
          const auto ray = model.camera.primary_ray(region.x + i, region.y + j, options.size);
          planes.set(static_cast<std::size_t>(j) * static_cast<std::size_t>(region.width) +
                         static_cast<std::size_t>(i),
                     tracer->pixel(ray));
        }
    };
  };
  result.complete = for_each_tile(planes.size, options.threads, make_worker, progress, stop);
  for (const auto& tracer : tracers) result.counts += tracer->counts();
  result.planes = std::move(planes);
  result.trace_seconds = seconds_since(traced);
  return result;
}

template RenderResult render_model(const Model<float>&, const RenderOptions&,
                                   const std::function<void(double)>&, std::stop_token);
template RenderResult render_model(const Model<double>&, const RenderOptions&,
                                   const std::function<void(double)>&, std::stop_token);
template RenderResult render_model(const Model<long double>&, const RenderOptions&,
                                   const std::function<void(double)>&, std::stop_token);

Region region_or_all(const Region& region, ImageSize size) {
  if (region.width == 0 && region.height == 0) return {0, 0, size.width, size.height};
  const bool fits = region.x >= 0 && region.y >= 0 && region.width > 0 && region.height > 0 &&
                    region.width <= size.width - region.x &&
                    region.height <= size.height - region.y;
  if (!fits) throw std::invalid_argument("the region does not lie within the image");
  return region;
}

RenderResult render(const Scene& scene, const RenderOptions& options,
                    const std::function<void(double)>& progress, std::stop_token stop) {
  if (options.antialiased()) return render_antialiased(scene, options, progress, stop);
  if (options.precision == Precision::double_)
    return render_in<double>(scene, options, progress, stop);
  if (options.precision == Precision::long_double)
    return render_in<long double>(scene, options, progress, stop);
  const glm::dvec3 offset = offset_for(scene, options.precision);
  return render_in<float>(recentred(scene, offset), options, progress, stop);
}

PixelTrace trace_pixel(const Scene& scene, const RenderOptions& options, int i, int j) {
  if (options.precision == Precision::double_) return trace_pixel_in<double>(scene, options, i, j);
  if (options.precision == Precision::long_double)
    return trace_pixel_in<long double>(scene, options, i, j);
  const glm::dvec3 offset = offset_for(scene, options.precision);
  PixelTrace result = trace_pixel_in<float>(recentred(scene, offset), options, i, j);
  for (TraceNode& node : result.log) {
    node.origin += offset;
    if (node.hit) node.point += offset;
  }
  return result;
}

}  // namespace sir
