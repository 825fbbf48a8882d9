#include "viewer/workshop.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "tracer/scene_path.h"
#include "viewer/file_watch.h"
#include "viewer/render_queue.h"
#include "viewer/source.h"

namespace sir::viewer {
namespace {

using Clock = std::chrono::steady_clock;

RenderOptions render_options(const WorkshopOptions& options) {
  RenderOptions render;
  render.size = options.size;
  const int all =
      options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
  render.threads = std::max(all - 1, 1);
  return render;
}

std::string rendering(int percent) { return "rendering " + std::to_string(percent) + " %"; }

/// The identity of a LUT file's contents.
struct LutVersion {};

struct Image {
  Image(const std::filesystem::path& input, std::size_t its_number, std::chrono::nanoseconds rest)
      : source(input), number(its_number), files(rest), lut_files(rest) {}

  const Source source;
  const std::size_t number;

  // Under the lock.
  Workshop::State state;
  std::shared_ptr<const LutVersion> lut = std::make_shared<const LutVersion>();
  std::uint64_t attempt = 0;  // number of the latest; what comes of earlier ones is not wanted
  double share = 0;           // of the pixels of the latest attempt's picture
  int percent = 0;            // as told
  bool asked_to_reload = false;
  Clock::time_point due = Clock::now();  // of the next look at the files

  // The watcher's.
  FileWatch files, lut_files;
  bool reading = true;  // an attempt has begun whose files are not read yet

  // The window's.
  std::map<Method, Latest<Workshop::Shown>> shown;
};

}  // namespace

class Workshop::Impl {
 public:
  explicit Impl(WorkshopOptions options)
      : options_(std::move(options)),
        worker_(options_.wake),
        renders_(render_options(options_)),
        watcher_([this](const std::stop_token& stop) { watch(stop); }) {}

  std::size_t open(const std::filesystem::path& input) {
    const std::scoped_lock lock(mutex_);
    const std::size_t number = images_.size();
    images_.push_back(std::make_unique<Image>(input, number, options_.watch_every));
    work_.notify_one();
    return number;
  }

  std::size_t count() const {
    const std::scoped_lock lock(mutex_);
    return images_.size();
  }

  State state(std::size_t number) const {
    const std::scoped_lock lock(mutex_);
    return images_.at(number)->state;
  }

  Shown shown(std::size_t number, Method method) {
    Image& image = this->image(number);
    const Ingredients of = ingredients(image, method);
    if (of.empty()) return {};
    Latest<Shown>& latest = image.shown[method];
    const auto picture = std::static_pointer_cast<const Picture>(of.front());
    const bool current = latest.is_current(of);  // asked first: it may become so at any time
    const auto made = latest.get(
        worker_, of, [picture, method, rendition = options_.rendition](std::stop_token stop) {
          if (const auto file = lut_file(picture->base, rendition);
              file && method == Method::lut_file)
            refuse_special_file(*file);
          return std::make_shared<const Shown>(
              picture, std::make_shared<const Rendition>(
                           make_rendition(*picture, method, rendition, std::move(stop))));
        });
    if (!made) return {};
    return {made->picture, made->rendition, current};
  }

  std::string error(std::size_t number, Method method) const {
    return image(number).shown[method].error();
  }

  void reload(std::size_t number) {
    const std::scoped_lock lock(mutex_);
    Image& image = *images_.at(number);
    image.asked_to_reload = true;
    image.state.busy = true;
    image.due = Clock::now();
    work_.notify_one();
  }

  void end_drawing(std::size_t number) {
    worker_.end_drawing();
    renders_.look_at(number);
    const std::scoped_lock lock(mutex_);
    looked_at_ = number;
  }

  Worker& worker() { return worker_; }

 private:
  Image& image(std::size_t number) const {
    const std::scoped_lock lock(mutex_);
    return *images_.at(number);
  }

  // None where there is nothing to make.
  Ingredients ingredients(const Image& image, Method method) const {
    const std::scoped_lock lock(mutex_);
    if (!image.state.picture || method == Method::true_colour) return {};
    if (method == Method::lut_file) return {image.state.picture, image.lut};
    return {image.state.picture};
  }

  void watch(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      const auto now = Clock::now();
      if (Image* image = next_due()) {
        if (image->due <= now) {
          const bool reload = std::exchange(image->asked_to_reload, false);
          if (reload) ++image->attempt;
          lock.unlock();
          look(*image, reload);
          lock.lock();
          if (!image->asked_to_reload) image->due = Clock::now() + options_.watch_every;
          continue;
        }
        work_.wait_until(lock, stop, image->due, [&] { return next_due()->due <= Clock::now(); });
      } else {
        work_.wait(lock, stop, [this] { return !images_.empty(); });
      }
    }
  }

  // The one that is looked at, if it is time; else the one whose time comes first.
  Image* next_due() const {
    if (images_.empty()) return nullptr;
    if (looked_at_ < images_.size() && images_[looked_at_]->due <= Clock::now())
      return images_[looked_at_].get();
    return std::ranges::min_element(images_, {}, [](const auto& image) { return image->due; })
        ->get();
  }

  void look(Image& image, bool reload) {
    look_at_lut(image, reload);
    image.files.look(image.source.files());
    if (reload) image.files.pretend_change();
    if (image.files.changed() && !std::exchange(image.reading, true)) begin_attempt(image);
    if (image.files.ready()) read(image);
  }

  // The window is told of a LUT file's change when that has come to rest.
  void look_at_lut(Image& image, bool reload) {
    const auto& base = image.source.base();
    image.lut_files.look({lut_file(base, options_.rendition).value_or(with_suffix(base, "LUT"))});
    if (reload) image.lut_files.pretend_change();
    if (!image.lut_files.ready()) return;
    image.lut_files.take();
    {
      const std::scoped_lock lock(mutex_);
      image.lut = std::make_shared<const LutVersion>();
    }
    options_.wake();
  }

  // What an earlier attempt still does is in vain.
  void begin_attempt(Image& image) {
    {
      const std::scoped_lock lock(mutex_);
      ++image.attempt;
      image.state.busy = true;
    }
    renders_.take_back(image.number);
    options_.wake();
  }

  void read(Image& image) {
    SourceContents contents;
    std::string error;
    try {
      contents = read_source(image.source, options_.size);
    } catch (const std::exception& failure) {
      error = failure.what();
    }
    image.files.look(image.source.files());
    if (!image.files.ready()) return;  // they changed while they were read
    image.files.take();
    image.reading = false;
    if (!error.empty()) fail(image, image.attempt, error);
    else if (contents.scene) render(image, std::move(contents.scene));
    else show(image, image.attempt, std::move(contents.picture));
  }

  void render(Image& image, std::shared_ptr<const Scene> scene) {
    const std::uint64_t attempt = image.attempt;
    {
      const std::scoped_lock lock(mutex_);
      image.state.message = rendering(image.percent = 0);
      image.state.failed = false;
      image.share = 0;
    }
    options_.wake();
    RenderJob job;
    job.number = image.number;
    job.scene = scene;
    job.show = [this, &image, attempt, scene](const Planes& planes, double share) {
      if (!is_finer(image, attempt, share)) return;
      show(image, attempt,
           std::make_shared<const Picture>(
               Picture{image.source.input(), image.source.base(), planes, scene, share}));
    };
    job.progress = [this, &image, attempt](double share) { tell(image, attempt, share); };
    job.failed = [this, &image, attempt](const std::string& error) { fail(image, attempt, error); };
    renders_.put(std::move(job));
  }

  // A render that was put off and begins anew has coarser pictures than are there already.
  bool is_finer(const Image& image, std::uint64_t attempt, double share) const {
    const std::scoped_lock lock(mutex_);
    return attempt == image.attempt && share > image.share;
  }

  void tell(Image& image, std::uint64_t attempt, double share) {
    const int percent = static_cast<int>(100 * share);
    {
      const std::scoped_lock lock(mutex_);
      if (attempt != image.attempt || !image.state.busy || percent == image.percent) return;
      image.state.message = rendering(image.percent = percent);
    }
    options_.wake();
  }

  void show(Image& image, std::uint64_t attempt, std::shared_ptr<const Picture> picture) {
    {
      const std::scoped_lock lock(mutex_);
      if (attempt != image.attempt) return;
      image.share = picture->share;
      image.state.picture = std::move(picture);
      ++image.state.version;
      image.state.failed = false;
      if (image.share >= 1) {
        image.state.message.clear();
        image.state.busy = image.asked_to_reload;
      }
    }
    options_.wake();
  }

  void fail(Image& image, std::uint64_t attempt, const std::string& error) {
    {
      const std::scoped_lock lock(mutex_);
      if (attempt != image.attempt) return;
      image.state.message = error;
      image.state.failed = true;
      image.state.busy = image.asked_to_reload;
    }
    options_.wake();
  }

  const WorkshopOptions options_;
  mutable std::mutex mutex_;
  std::condition_variable_any work_;  // for the watcher: an image is due earlier than thought
  std::deque<std::unique_ptr<Image>> images_;
  std::size_t looked_at_ = 0;
  Worker worker_;
  RenderQueue renders_;
  std::jthread watcher_;  // the last member: it uses the others
};

Workshop::Workshop(WorkshopOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {}
Workshop::~Workshop() = default;

std::size_t Workshop::open(const std::filesystem::path& input) { return impl_->open(input); }
std::size_t Workshop::count() const { return impl_->count(); }
Workshop::State Workshop::state(std::size_t number) const { return impl_->state(number); }

Workshop::Shown Workshop::shown(std::size_t number, Method method) {
  return impl_->shown(number, method);
}

std::string Workshop::rendition_error(std::size_t number, Method method) const {
  return impl_->error(number, method);
}

void Workshop::reload(std::size_t number) { impl_->reload(number); }
void Workshop::end_drawing(std::size_t number) { impl_->end_drawing(number); }
Worker& Workshop::worker() { return impl_->worker(); }

}  // namespace sir::viewer
