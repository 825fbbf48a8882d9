#include "tracer/render.h"

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tracer/recentre.h"
#include "tracer/trace.h"

namespace sir {
namespace {

constexpr int kTile = 32;  // pixels; small enough to share the work out evenly

Region whole_or(const Region& region, ImageSize size) {
  if (region.width == 0 && region.height == 0) return {0, 0, size.width, size.height};
  const bool fits = region.x >= 0 && region.y >= 0 && region.width > 0 && region.height > 0 &&
                    region.width <= size.width - region.x &&
                    region.height <= size.height - region.y;
  if (!fits) throw std::invalid_argument("the region does not lie within the image");
  return region;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Hands out tiles to threads and gathers what they report.
template <typename T>
class Rendering {
 public:
  Rendering(const Model<T>& model, const RenderOptions& options, const Region& region,
            const std::function<void(double)>& progress, std::stop_token stop)
      : model_(model),
        options_(options),
        region_(region),
        progress_(progress),
        stop_(std::move(stop)),
        across_((region.width + kTile - 1) / kTile),
        tiles_(across_ * ((region.height + kTile - 1) / kTile)),
        planes_(ImageSize{region.width, region.height}) {}

  void run(RenderResult& result) {
    const int wanted = options_.threads > 0 ? options_.threads
                                            : static_cast<int>(std::thread::hardware_concurrency());
    const int threads = std::clamp(wanted, 1, std::max(tiles_, 1));
    {
      std::vector<std::jthread> pool;
      for (int i = 1; i < threads; ++i) pool.emplace_back([this] { work(); });
      work();
    }
    if (failure_) std::rethrow_exception(failure_);
    result.planes = std::move(planes_);
    result.counts = counts_;
    result.complete = done_ == tiles_;
  }

 private:
  void work() {
    try {
      Tracer<T> tracer(model_, options_.trace);
      for (int tile = next_++; tile < tiles_ && !stop_.stop_requested(); tile = next_++) {
        if (!render_tile(tracer, tile)) break;
        const std::scoped_lock lock(report_);
        ++done_;
        if (progress_) progress_(double(done_) / tiles_);
      }
      const std::scoped_lock lock(report_);
      counts_ += tracer.counts();
    } catch (...) {
      const std::scoped_lock lock(report_);
      failure_ = std::current_exception();
      next_ = tiles_;
    }
  }

  bool render_tile(Tracer<T>& tracer, int tile) {
    const int left = tile % across_ * kTile, top = tile / across_ * kTile;
    const int right = std::min(left + kTile, region_.width);
    const int bottom = std::min(top + kTile, region_.height);
    for (int j = top; j < bottom; ++j) {
      if (stop_.stop_requested()) return false;
      for (int i = left; i < right; ++i) {
        const auto ray = model_.camera.primary_ray(region_.x + i, region_.y + j, options_.size);
        const auto pixel = static_cast<std::size_t>(j) * static_cast<std::size_t>(region_.width) +
                           static_cast<std::size_t>(i);
        planes_.set(pixel, to_rgb8(tracer.radiance(ray)));
      }
    }
    return true;
  }

  const Model<T>& model_;
  const RenderOptions& options_;
  const Region region_;
  const std::function<void(double)>& progress_;
  std::stop_token stop_;
  const int across_, tiles_;
  Planes planes_;
  std::atomic<int> next_{0};
  std::mutex report_;
  int done_ = 0;
  RayCounts counts_;
  std::exception_ptr failure_;
};

template <typename T>
RenderResult render_in(const Scene& scene, const RenderOptions& options,
                       const std::function<void(double)>& progress, std::stop_token stop) {
  const Region region = whole_or(options.region, options.size);
  RenderResult result;
  const auto start = std::chrono::steady_clock::now();
  const Model<T> model(scene, options.trace.allowed_effects);
  result.effects = model.effects;
  result.prepare_seconds = seconds_since(start);
  const auto traced = std::chrono::steady_clock::now();
  Rendering<T>(model, options, region, progress, std::move(stop)).run(result);
  result.trace_seconds = seconds_since(traced);
  return result;
}

template <typename T>
PixelTrace trace_pixel_in(const Scene& scene, const RenderOptions& options, int i, int j) {
  const Model<T> model(scene, options.trace.allowed_effects);
  Tracer<T> tracer(model, options.trace);
  PixelTrace result;
  result.pixel =
      to_rgb8(tracer.radiance(model.camera.primary_ray(i, j, options.size), &result.log));
  return result;
}

}  // namespace

RenderResult render(const Scene& scene, const RenderOptions& options,
                    const std::function<void(double)>& progress, std::stop_token stop) {
  if (options.precision == Precision::double_)
    return render_in<double>(scene, options, progress, std::move(stop));
  const glm::dvec3 offset = offset_for(scene, options.precision);
  return render_in<float>(recentred(scene, offset), options, progress, std::move(stop));
}

PixelTrace trace_pixel(const Scene& scene, const RenderOptions& options, int i, int j) {
  if (options.precision == Precision::double_) return trace_pixel_in<double>(scene, options, i, j);
  const glm::dvec3 offset = offset_for(scene, options.precision);
  PixelTrace result = trace_pixel_in<float>(recentred(scene, offset), options, i, j);
  for (TraceNode& node : result.log) {
    node.origin += offset;
    if (node.hit) node.point += offset;
  }
  return result;
}

}  // namespace sir
