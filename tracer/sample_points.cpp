#include "tracer/sample_points.h"

#include <algorithm>
#include <vector>

#include "tracer/pixel_tracer.h"
#include "tracer/recentre.h"

namespace sir {

// One of the scalar types behind a common face.
class PointSampler::Work {
 public:
  virtual ~Work() = default;
  virtual bool trace(std::span<const ScreenPoint> points, std::span<Rgb8> colours,
                     const std::function<void(double)>& progress, const std::stop_token& stop) = 0;
  virtual std::uint32_t keep_no_more() = 0;
  virtual RayCounts counts() const = 0;
  virtual const EffectSet& effects() const = 0;
};

template <typename T>
class PointSampler::WorkIn final : public PointSampler::Work {
 public:
  WorkIn(const Scene& scene, const RenderOptions& options)
      : options_(options), model_(scene, options.trace.possible_effects(), options.trace.formulas) {
    effects_ = model_.effects;
    effects_.antialias = options.antialiased();
  }

  bool trace(std::span<const ScreenPoint> points, std::span<Rgb8> colours,
             const std::function<void(double)>& progress, const std::stop_token& stop) override {
    // Enough to go together, few enough to be stopped soon and for the last pieces to end
    // together. What asks for points has them in rows, or a pixel's side by side: sorting
    // them by place was measured to gain nothing.
    constexpr std::size_t kPiece = 256;
    const std::uint32_t stage = stage_++;
    std::size_t workers = 0;
    const auto make_worker = [&]() -> PieceWorker {
      if (workers == tracers_.size())
        tracers_.push_back(std::make_unique<PixelTracer<T>>(model_, options_.trace));
      return [&, tracer = tracers_[workers++].get(),
              rays = std::vector<RayCena<T>>()](std::int64_t piece) mutable {
        const std::size_t begin = static_cast<std::size_t>(piece) * kPiece;
        const std::size_t count = std::min(kPiece, points.size() - begin);
        const auto seen = colours.subspan(begin, count);
        if (keeper_ && keeper_->take({stage, begin}, seen)) return;
        const RayCounts before = keeper_ ? tracer->counts() : RayCounts{};
        rays.clear();
        for (const ScreenPoint& point : points.subspan(begin, count))
          rays.push_back(model_.camera.ray_through(point.x, point.y, options_.size));
        tracer->pixels(rays, seen);
        if (keeper_) keeper_->keep({stage, begin}, seen, tracer->counts().since(before));
      };
    };
    const auto pieces = static_cast<std::int64_t>((points.size() + kPiece - 1) / kPiece);
    return for_each_piece(pieces, options_.threads, make_worker, progress, stop);
  }

  std::uint32_t keep_no_more() override {
    keeper_ = nullptr;
    return stage_;
  }

  RayCounts counts() const override {
    RayCounts sum;
    for (const auto& tracer : tracers_) sum += tracer->counts();
    if (options_.keeper) sum += options_.keeper->taken_counts();
    return sum;
  }

  const EffectSet& effects() const override { return effects_; }

 private:
  RenderOptions options_;
  Model<T> model_;
  EffectSet effects_;
  TileKeeper* keeper_ = options_.keeper;
  std::uint32_t stage_ = 0;
  std::vector<std::unique_ptr<PixelTracer<T>>> tracers_;
};

PointSampler::PointSampler(const Scene& scene, const RenderOptions& options) {
  if (options.precision == Precision::double_) {
    work_ = std::make_unique<WorkIn<double>>(scene, options);
    return;
  }
  if (options.precision == Precision::long_double) {
    work_ = std::make_unique<WorkIn<long double>>(scene, options);
    return;
  }
  const glm::dvec3 offset = offset_for(scene, options.precision);
  work_ = std::make_unique<WorkIn<float>>(Recentred(scene, offset), options);
}

PointSampler::~PointSampler() = default;
PointSampler::PointSampler(PointSampler&&) noexcept = default;
PointSampler& PointSampler::operator=(PointSampler&&) noexcept = default;

bool PointSampler::trace(std::span<const ScreenPoint> points, std::span<Rgb8> colours,
                         const std::function<void(double)>& progress, const std::stop_token& stop) {
  return work_->trace(points, colours, progress, stop);
}

SampleSource PointSampler::source(std::function<void(double)> progress, std::stop_token stop) {
  return [this, progress = std::move(progress), stop = std::move(stop)](
             std::span<const ScreenPoint> points, std::span<Rgb8> colours, const Share& share) {
    std::function<void(double)> report;
    if (progress)
      report = [&](double done) { progress(share.from + done * (share.to - share.from)); };
    return trace(points, colours, report, stop);
  };
}

std::uint32_t PointSampler::keep_no_more() { return work_->keep_no_more(); }
RayCounts PointSampler::counts() const { return work_->counts(); }
const EffectSet& PointSampler::effects() const { return work_->effects(); }

}  // namespace sir
