#include "viewer/worker.h"

#include <algorithm>
#include <utility>

namespace sir::viewer {

class Worker::Request {
 public:
  Request(Work request_work, std::uint64_t drawing)
      : work(std::move(request_work)), asked_in(drawing) {}

  const Work work;
  std::stop_source stop;
  std::uint64_t asked_in;  // drawing; under the worker's lock
};

Worker::Worker(std::function<void()> wake)
    : wake_(std::move(wake)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

Worker::~Worker() {
  thread_.request_stop();
  const std::scoped_lock lock(mutex_);
  waiting_.clear();
  if (running_) running_->stop.request_stop();
}

Worker::Handle Worker::ask(Work work) {
  const std::scoped_lock lock(mutex_);
  waiting_.push_back(std::make_shared<Request>(std::move(work), drawing_));
  changed_.notify_one();
  return waiting_.back();
}

bool Worker::ask_again(const Handle& handle) {
  const std::scoped_lock lock(mutex_);
  const bool alive = (handle == running_ && !handle->stop.stop_requested()) ||
                     std::ranges::find(waiting_, handle) != waiting_.end();
  handle->asked_in = drawing_;
  return alive;
}

void Worker::take_back(const Handle& handle) {
  const std::scoped_lock lock(mutex_);
  waiting_.remove(handle);
  handle->stop.request_stop();
}

void Worker::end_drawing() {
  const std::scoped_lock lock(mutex_);
  const auto unasked = [this](const Handle& handle) { return handle->asked_in < drawing_; };
  waiting_.remove_if(unasked);
  if (running_ && unasked(running_) && !waiting_.empty()) running_->stop.request_stop();
  ++drawing_;
}

void Worker::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return !waiting_.empty(); })) {
    if (stop.stop_requested()) return;
    const auto next = std::ranges::max_element(waiting_, {}, &Request::asked_in);
    running_ = *next;
    waiting_.erase(next);
    const Handle running = running_;
    lock.unlock();
    running->work(running->stop.get_token());
    lock.lock();
    running_.reset();
    lock.unlock();
    wake_();
    lock.lock();
  }
}

}  // namespace sir::viewer
