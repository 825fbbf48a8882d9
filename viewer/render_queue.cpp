#include "viewer/render_queue.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "tracer/sample_progressive.h"

namespace sir::viewer {

RenderQueue::RenderQueue(RenderOptions options)
    : options_(std::move(options)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

RenderQueue::~RenderQueue() {
  thread_.request_stop();
  const std::scoped_lock lock(mutex_);
  jobs_.clear();
  stop_running_.request_stop();
}

void RenderQueue::put(RenderJob job) {
  take_back(job.number);
  const std::scoped_lock lock(mutex_);
  jobs_.push_back(std::make_shared<const RenderJob>(std::move(job)));
  put_off_running();
  changed_.notify_one();
}

void RenderQueue::take_back(std::size_t number) {
  const std::scoped_lock lock(mutex_);
  std::erase_if(jobs_, [&](const Job& job) { return job->number == number; });
  if (running_ && running_->number == number) stop_running_.request_stop();
}

void RenderQueue::look_at(std::size_t number) {
  const std::scoped_lock lock(mutex_);
  looked_at_ = number;
  put_off_running();
}

void RenderQueue::put_off_running() {
  if (running_ && !jobs_.empty() && next() != running_) stop_running_.request_stop();
}

// There must be one. The running one stays first of those that are not looked at.
RenderQueue::Job RenderQueue::next() const {
  const auto looked_at =
      std::ranges::find(jobs_, looked_at_, [](const Job& job) { return job->number; });
  if (looked_at != jobs_.end()) return *looked_at;
  return std::ranges::find(jobs_, running_) != jobs_.end() ? running_ : jobs_.front();
}

void RenderQueue::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return !jobs_.empty(); })) {
    if (stop.stop_requested()) return;
    running_ = next();
    stop_running_ = std::stop_source();
    const Job job = running_;
    const std::stop_token stop_job = stop_running_.get_token();
    lock.unlock();
    const bool ended = render(*job, stop_job);
    lock.lock();
    if (ended) std::erase(jobs_, job);
    running_.reset();
  }
}

// False where it was stopped on the way.
bool RenderQueue::render(const RenderJob& job, std::stop_token stop) const {
  try {
    return render_progressive(
               *job.scene, options_,
               [&](const Planes& picture, const Stage& stage) { job.show(picture, stage.share); },
               stop, job.progress)
        .complete;
  } catch (const std::exception& error) {
    job.failed(error.what());
    return true;
  }
}

}  // namespace sir::viewer
