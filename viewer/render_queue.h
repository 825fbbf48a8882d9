// Renders scenes in the background, coarse to fine, one at a time: first the one that is looked at.
// The thesis's user starts SIR and waits (3.3).
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "tracer/render.h"

namespace sir::viewer {

/// A scene to be rendered, and who is told about it. The functions are called by the queue's
/// thread, `progress` by the renderer's others too, one call at a time. After the job was taken
/// back a call may still come.
struct RenderJob {
  std::size_t number = 0;  ///< of the image: at most one job each
  std::shared_ptr<const Scene> scene;
  std::function<void(const Planes& picture, double share)> show;  ///< each finer picture
  std::function<void(double share)> progress;                     ///< of the pixels, in [0,1]
  std::function<void(const std::string& error)> failed;
};

/// The functions are for any thread and do not wait.
class RenderQueue {
 public:
  explicit RenderQueue(RenderOptions options);

  /// Stops the running render, which takes up to 256 pixels of each of its threads.
  ~RenderQueue();
  RenderQueue(const RenderQueue&) = delete;
  RenderQueue& operator=(const RenderQueue&) = delete;

  /// Adds a job, in place of the same image's.
  void put(RenderJob job);

  /// Takes back an image's job, waiting or running.
  void take_back(std::size_t number);

  /// This image's job goes first from now on: that of another image which is running is put off,
  /// to be begun anew later.
  void look_at(std::size_t number);

 private:
  using Job = std::shared_ptr<const RenderJob>;
  void run(const std::stop_token& stop);
  Job next() const;
  bool render(const RenderJob& job, std::stop_token stop) const;
  void put_off_running();

  const RenderOptions options_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::vector<Job> jobs_;  // in the order of putting; the one that runs too
  Job running_;
  std::stop_source stop_running_;
  std::size_t looked_at_ = 0;
  std::jthread thread_;  // the last member: it uses the others
};

}  // namespace sir::viewer
