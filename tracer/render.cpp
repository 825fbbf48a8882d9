#include "tracer/render.h"

#include <chrono>
#include <memory>
#include <stdexcept>
#include <vector>

#include "tracer/processor_time.h"
#include "tracer/recentre.h"
#include "tracer/sample_antialias.h"
#include "tracer/trace.h"
#include "tracer/wavefront.h"

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
  const double processor = processor_seconds();
  Planes planes(ImageSize{region.width, region.height});
  std::vector<std::shared_ptr<Wavefront<T>>> fronts;
  const auto make_worker = [&]() -> TileWorker {
    fronts.push_back(std::make_shared<Wavefront<T>>(model, options.trace));
    return [&, front = fronts.back(), rays = std::vector<RayCena<T>>(),
            bytes = std::vector<Rgb8>()](const Region& tile) mutable {
      // A few rows at a time: enough rays to go together, and soon to be stopped.
      constexpr int kRows = 8;
      for (int top = 0; top < tile.height && !stop.stop_requested(); top += kRows) {
        const int rows = std::min(kRows, tile.height - top);
        rays.clear();
        for (int j = tile.y + top; j < tile.y + top + rows; ++j)
          for (int i = tile.x; i < tile.x + tile.width; ++i)
            rays.push_back(model.camera.primary_ray(region.x + i, region.y + j, options.size));
        bytes.resize(rays.size());
        front->pixels(rays, bytes);
        for (std::size_t p = 0; p < bytes.size(); ++p) {
          const auto width = static_cast<std::size_t>(tile.width);
          const std::size_t row = static_cast<std::size_t>(tile.y + top) + p / width;
          planes.set(row * static_cast<std::size_t>(region.width) +
                         static_cast<std::size_t>(tile.x) + p % width,
                     bytes[p]);
        }
      }
    };
  };
  result.complete = for_each_tile(planes.size, options.threads, make_worker, progress, stop);
  for (const auto& front : fronts) result.counts += front->counts();
  result.planes = std::move(planes);
  result.trace_seconds = seconds_since(traced);
  result.processor_seconds = processor_seconds() - processor;
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
