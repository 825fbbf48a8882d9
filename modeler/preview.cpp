#include "modeler/preview.h"

#include <exception>
#include <utility>

#include "modeler/ghosts.h"
#include "modeler/silhouette.h"
#include "modeler/view.h"
#include "tracer/colour.h"
#include "tracer/sample_progressive.h"

namespace sir::modeler {
namespace {

// Ghosts of the pictures on the way: as coarse as serves the eye.
constexpr int kGhostBlock = 4;

constexpr Rgb8 kLine{255, 255, 255};

void draw_lines(const Planes& lines, Planes& picture) {
  for (std::size_t pixel = 0; pixel < picture.size.pixels(); ++pixel)
    if (lines.channel[0][pixel] != 0) picture.set(pixel, kLine);
}

Planes background_of(const PreviewRequest& request) {
  // Of a scene's made-up light the background does not hang on what is in it.
  const Lighting lighting = request.lighting.value_or(made_up_lighting(request.camera));
  const Rgb8 colour = to_rgb8(Colour<double>(lighting.background));
  Planes planes(request.size);
  for (std::size_t pixel = 0; pixel < request.size.pixels(); ++pixel) planes.set(pixel, colour);
  return planes;
}

}  // namespace

Scene preview_scene(const PreviewRequest& request) {
  Scene scene = scene_of(*request.solid, request.camera);
  dress(scene, request.lighting, request.surfaces);
  return scene;
}

Preview::Preview(std::function<void()> wake, int threads)
    : wake_(std::move(wake)),
      threads_(threads),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

Preview::~Preview() {
  thread_.request_stop();
  cancel();
}

std::uint64_t Preview::request(PreviewRequest wanted) {
  const std::scoped_lock lock(mutex_);
  wanted_ = std::move(wanted);
  current_.request_stop();
  error_.clear();
  changed_.notify_one();
  return ++number_;
}

void Preview::cancel() {
  const std::scoped_lock lock(mutex_);
  wanted_.reset();
  current_.request_stop();
}

std::shared_ptr<const PreviewPicture> Preview::take() const {
  const std::scoped_lock lock(mutex_);
  return newest_;
}

std::string Preview::error() const {
  const std::scoped_lock lock(mutex_);
  return error_;
}

bool Preview::busy() const {
  const std::scoped_lock lock(mutex_);
  return wanted_.has_value() || tracing_;
}

void Preview::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return wanted_.has_value(); })) {
    if (stop.stop_requested()) return;
    const PreviewRequest request = std::move(*wanted_);
    wanted_.reset();
    const std::uint64_t number = number_;
    current_ = std::stop_source();
    const std::stop_token aborted = current_.get_token();
    tracing_ = true;
    lock.unlock();
    std::string reason;
    try {
      trace(request, number, aborted);
    } catch (const std::exception& failure) {
      reason = failure.what();
    }
    lock.lock();
    tracing_ = false;
    if (!aborted.stop_requested()) error_ = std::move(reason);
    lock.unlock();
    wake_();
    lock.lock();
  }
}

void Preview::trace(const PreviewRequest& request, std::uint64_t number,
                    const std::stop_token& stop) {
  std::unique_ptr<Picker> picker;
  GhostLayer ghosts;
  std::vector<GuidePixel> guides;
  Planes lines;
  const auto show = [&](Planes planes, int block, bool whole) {
    if (stop.stop_requested()) return;
    blend(ghosts, planes);
    if (lines.size == planes.size) draw_lines(lines, planes);
    draw(guides, planes);
    auto picture = std::make_shared<PreviewPicture>();
    *picture = {std::move(planes), number, block, whole};
    publish(std::move(picture), stop);
  };
  if (!request.solid) {
    guides = pixels_of(request.guides, request.camera, request.size, nullptr, stop);
    return show(background_of(request), 1, true);
  }
  const Scene scene = preview_scene(request);
  Scene ghost_scene;
  const bool haunted = request.ghosts && make_ghost_scene(scene, ghost_scene);
  RenderOptions options;
  options.size = request.size;
  options.threads = threads_;
  // The last picture of the tracer is the last of all where there is nothing to be laid over it.
  const bool more = haunted || request.silhouette;
  bool first = true;
  RenderResult result = render_progressive(
      scene, options,
      [&](const Planes& picture, const Stage& stage) {
        if (std::exchange(first, false)) {
          if (haunted) ghosts = ghost_layer(ghost_scene, request.size, threads_, kGhostBlock, stop);
          if (!request.guides.empty() && !stop.stop_requested()) {
            picker = std::make_unique<Picker>(request.solid, request.camera, request.size);
            guides = pixels_of(request.guides, request.camera, request.size, picker.get(), stop);
          }
        }
        const bool last = stage.block == 1 && !stage.refined_only;
        if (!last || !more) show(picture, stage.block, last);
      },
      stop);
  if (!result.complete || !more) return;
  if (haunted) ghosts = ghost_layer(ghost_scene, request.size, threads_, 1, stop);
  if (request.silhouette) lines = silhouette(*request.solid, scene, request.size, stop);
  show(std::move(result.planes), 1, true);
}

void Preview::publish(std::shared_ptr<const PreviewPicture> picture, const std::stop_token& stop) {
  {
    const std::scoped_lock lock(mutex_);
    if (stop.stop_requested()) return;
    newest_ = std::move(picture);
  }
  wake_();
}

}  // namespace sir::modeler
