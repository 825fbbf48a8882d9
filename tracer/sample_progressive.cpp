#include "tracer/sample_progressive.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <vector>

#include "tracer/processor_time.h"
#include "tracer/sample_antialias.h"
#include "tracer/sample_points.h"

namespace sir {
namespace {

constexpr int kCoarsest = 16;

class Progressive {
 public:
  Progressive(const Scene& scene, const RenderOptions& options,
              const std::function<void(double)>& progress, const std::stop_token& stop)
      : region_(region_or_all(options.region, options.size)),
        options_(options),
        progress_(progress),
        stop_(stop),
        start_(Clock::now()),
        sampler_(scene, options),
        picture_(ImageSize{region_.width, region_.height}),
        state_(picture_.size.pixels(), State::guessed) {
    result_.effects = sampler_.effects();
    result_.prepare_seconds = seconds_since(start_);
    start_ = Clock::now();
    processor_start_ = processor_seconds();
  }

  // Time that was not spent on tracing.
  void leave_out(std::chrono::steady_clock::duration time, double processor) {
    start_ += time;
    processor_start_ += processor;
  }

  double share() const { return double(traced_) / double(picture_.size.pixels()); }
  const Planes& picture() const { return picture_; }

  // Traces every block of the picture that was not; false where stopped, as below.
  bool trace_all(int block) {
    for (int y = 0; y < region_.height; y += block)
      for (int x = 0; x < region_.width; x += block) want(x, y);
    return trace_wanted(block);
  }

  // Divides the blocks that differ from one of their neighbours.
  bool refine(int block) {
    for (int y = 0; y < region_.height; y += block)
      for (int x = 0; x < region_.width; x += block)
        if (differs(x, y, block))
          for (const int v : {y, y + block / 2})
            for (const int u : {x, x + block / 2}) want(u, v);
    return trace_wanted(block / 2);
  }

  bool antialias() {
    RenderResult finished;
    if (!sir::antialias(options_, sampler_, progress_, stop_, finished)) return false;
    picture_ = std::move(finished.planes);
    result_.antialias = std::move(finished.antialias);
    return true;
  }

  RenderResult finish(bool complete) {
    result_.complete = complete;
    result_.counts = sampler_.counts();
    result_.planes = std::move(picture_);
    result_.trace_seconds = seconds_since(start_);
    result_.processor_seconds = processor_seconds() - processor_start_;
    return std::move(result_);
  }

 private:
  using Clock = std::chrono::steady_clock;
  enum class State : std::uint8_t { guessed, wanted, traced };

  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(region_.width) +
           static_cast<std::size_t>(x);
  }

  void want(int x, int y) {
    if (x >= region_.width || y >= region_.height) return;
    State& state = state_[index(x, y)];
    if (state == State::guessed) state = State::wanted;
  }

  bool differs(int x, int y, int block) const {
    const Rgb8 own = picture_.at(index(x, y));
    for (int v = std::max(y - block, 0); v <= y + block && v < region_.height; v += block)
      for (int u = std::max(x - block, 0); u <= x + block && u < region_.width; u += block)
        if (picture_.at(index(u, v)) != own) return true;
    return false;
  }

  // Traces the pixels wanted, which are top left corners of blocks, and fills these.
  bool trace_wanted(int block) {
    constexpr std::size_t kPoints = 1 << 16;  // at a time
    for (int y = 0; y < region_.height; y += block)
      for (int x = 0; x < region_.width; x += block) {
        if (state_[index(x, y)] != State::wanted) continue;
        pixels_.push_back({x, y});
        if (pixels_.size() == kPoints && !trace_pixels(block)) return false;
      }
    return trace_pixels(block);
  }

  bool trace_pixels(int block) {
    points_.clear();
    for (const auto& [x, y] : pixels_)
      points_.push_back({region_.x + x + 0.5, region_.y + y + 0.5});
    colours_.resize(points_.size());
    const double all = double(picture_.size.pixels());
    const Share part{double(traced_) / all, double(traced_ + points_.size()) / all};
    if (!sampler_.source(progress_, stop_)(points_, colours_, part)) return false;
    for (std::size_t p = 0; p < pixels_.size(); ++p) {
      const auto [x, y] = pixels_[p];
      state_[index(x, y)] = State::traced;
      for (int v = y; v < std::min(y + block, region_.height); ++v)
        for (int u = x; u < std::min(x + block, region_.width); ++u)
          picture_.set(index(u, v), colours_[p]);
    }
    traced_ += pixels_.size();
    pixels_.clear();
    return true;
  }

  struct Pixel {
    int x, y;  // in the region
  };

  const Region region_;
  const RenderOptions options_;
  const std::function<void(double)>& progress_;
  const std::stop_token& stop_;
  Clock::time_point start_;
  double processor_start_ = 0;
  PointSampler sampler_;
  Planes picture_;
  std::vector<State> state_;  // of each pixel
  std::size_t traced_ = 0;    // pixels
  RenderResult result_;

  // Kept for their memory.
  std::vector<Pixel> pixels_;
  std::vector<ScreenPoint> points_;
  std::vector<Rgb8> colours_;
};

}  // namespace

RenderResult render_progressive(const Scene& scene, const RenderOptions& options,
                                const ShowStage& show, std::stop_token stop,
                                const std::function<void(double)>& progress) {
  if (options.antialiased() && !options.antialias.valid())
    throw std::invalid_argument("an option of antialiasing is out of its range");
  Progressive work(scene, options, progress, stop);
  if (!work.trace_all(kCoarsest)) return work.finish(false);
  const auto pause = [&](const Stage& stage) {
    const auto start = std::chrono::steady_clock::now();
    const double processor = processor_seconds();
    show(work.picture(), stage);
    work.leave_out(std::chrono::steady_clock::now() - start, processor_seconds() - processor);
  };
  pause({kCoarsest, false, false, work.share()});
  for (int block = kCoarsest; block > 1; block /= 2) {
    if (!work.refine(block)) return work.finish(false);
    pause({block / 2, true, false, work.share()});
  }
  if (!work.trace_all(1)) return work.finish(false);
  pause({1, false, false, work.share()});
  if (options.antialiased()) {
    if (!work.antialias()) return work.finish(false);
    pause({1, false, true, work.share()});
  }
  return work.finish(true);
}

RenderResult render_preview(const Scene& scene, const RenderOptions& options, int block,
                            bool refine, std::stop_token stop) {
  if (block < 1 || block > kCoarsest || (block & (block - 1)) != 0)
    throw std::invalid_argument("a preview has blocks of 16, 8, 4, 2 or 1 pixels");
  RenderOptions plain = options;
  plain.antialias.mode = Antialias::none;
  const std::function<void(double)> silent;
  Progressive work(scene, plain, silent, stop);
  bool complete = work.trace_all(refine ? kCoarsest : block);
  for (int side = kCoarsest; complete && refine && side > block; side /= 2)
    complete = work.refine(side);
  return work.finish(complete);
}

}  // namespace sir
