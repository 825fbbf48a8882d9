#include "tracer/render.h"

#include <chrono>
#include <memory>
#include <stdexcept>
#include <vector>

#include "tracer/pixel_tracer.h"
#include "tracer/processor_time.h"
#include "tracer/recentre.h"
#include "tracer/sample_antialias.h"
#include "tracer/trace.h"

namespace sir {
namespace {

// Pixels along the sides of a packet and of what is traced in one go.
constexpr int kPacketSide = 4, kBatchSide = 16;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The squares of `side` that a region falls into; those on its edge are smaller.
template <typename Visit>
void for_each_square(const Region& region, int side, Visit&& visit) {
  for (int y = 0; y < region.height; y += side)
    for (int x = 0; x < region.width; x += side)
      visit(Region{region.x + x, region.y + y, std::min(side, region.width - x),
                   std::min(side, region.height - y)});
}

// A tile on its way between the planes and a keeper, where there is one.
class KeptTile {
 public:
  KeptTile(TileKeeper* keeper, const Region& tile, std::size_t first, Planes& planes)
      : keeper_(keeper), tile_(tile), first_(first), planes_(planes) {}

  // Fills in its pixels where the keeper has them.
  bool taken() {
    if (!keeper_) return false;
    colours_.resize(ImageSize{tile_.width, tile_.height}.pixels());
    if (!keeper_->take({0, first_}, colours_)) return false;
    for_each_pixel([&](std::size_t place, Rgb8& colour) { planes_.set(place, colour); });
    return true;
  }

  // It was not finished.
  void leave() { keeper_ = nullptr; }

  void keep(const RayCounts& cost) {
    if (!keeper_) return;
    for_each_pixel([&](std::size_t place, Rgb8& colour) { colour = planes_.at(place); });
    keeper_->keep({0, first_}, colours_, cost);
  }

 private:
  template <typename Visit>
  void for_each_pixel(Visit&& visit) {
    std::size_t at = 0;
    for (int y = 0; y < tile_.height; ++y)
      for (int x = 0; x < tile_.width; ++x, ++at)
        visit(first_ + static_cast<std::size_t>(y) * static_cast<std::size_t>(planes_.size.width) +
                  static_cast<std::size_t>(x),
              colours_[at]);
  }

  TileKeeper* keeper_;
  const Region& tile_;
  const std::size_t first_;
  Planes& planes_;
  std::vector<Rgb8> colours_;
};

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
  std::vector<std::shared_ptr<PixelTracer<T>>> tracers;
  const auto make_worker = [&]() -> TileWorker {
    tracers.push_back(std::make_shared<PixelTracer<T>>(model, options.trace));
    return [&, tracer = tracers.back(), rays = std::vector<RayCena<T>>(),
            places = std::vector<std::size_t>(),
            bytes = std::vector<Rgb8>()](const Region& tile) mutable {
      const auto place = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(region.width) +
               static_cast<std::size_t>(x);
      };
      KeptTile kept(options.keeper, tile, place(tile.x, tile.y), planes);
      if (kept.taken()) return;
      const RayCounts before = options.keeper ? tracer->counts() : RayCounts{};
      // Squares of squares, so that packets' rays are neighbours and batches too.
      for_each_square(tile, kBatchSide, [&](const Region& batch) {
        if (stop.stop_requested()) {
          kept.leave();
          return;
        }
        rays.clear();
        places.clear();
        for_each_square(batch, kPacketSide, [&](const Region& block) {
          for (int y = block.y; y < block.y + block.height; ++y)
            for (int x = block.x; x < block.x + block.width; ++x) {
              rays.push_back(model.camera.primary_ray(region.x + x, region.y + y, options.size));
              places.push_back(place(x, y));
            }
        });
        bytes.resize(rays.size());
        tracer->pixels(rays, bytes);
        for (std::size_t p = 0; p < bytes.size(); ++p) planes.set(places[p], bytes[p]);
      });
      if (options.keeper) kept.keep(tracer->counts().since(before));
    };
  };
  result.complete = for_each_tile(planes.size, options.threads, make_worker, progress, stop);
  for (const auto& tracer : tracers) result.counts += tracer->counts();
  if (options.keeper) result.counts += options.keeper->taken_counts();
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
  return render_in<float>(Recentred(scene, offset), options, progress, stop);
}

PixelTrace trace_pixel(const Scene& scene, const RenderOptions& options, int i, int j) {
  if (options.precision == Precision::double_) return trace_pixel_in<double>(scene, options, i, j);
  if (options.precision == Precision::long_double)
    return trace_pixel_in<long double>(scene, options, i, j);
  const glm::dvec3 offset = offset_for(scene, options.precision);
  PixelTrace result = trace_pixel_in<float>(Recentred(scene, offset), options, i, j);
  for (TraceNode& node : result.log) {
    node.origin += offset;
    if (node.hit) node.point += offset;
  }
  return result;
}

}  // namespace sir
