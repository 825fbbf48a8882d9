// One thread for what takes the window's thread too long. The thesis's user waits.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>

namespace sir::viewer {

/// Does the work that is asked for, one piece at a time: that of the latest drawing first, within
/// a drawing in the order of asking. All members are for one thread, the window's.
class Worker {
 public:
  using Work = std::function<void(std::stop_token)>;

  /// A piece of work, by which whoever asked for it can ask again.
  class Request;
  using Handle = std::shared_ptr<Request>;

  /// `wake` is called by the worker's thread after each piece.
  explicit Worker(std::function<void()> wake);

  /// Asks the running piece to stop and waits until it has; the others are never begun.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// The work must not throw. It should end soon after a stop request.
  Handle ask(Work work);

  /// Keeps a request from being dropped at the end of this drawing. False where it is done or was
  /// dropped; then it takes a new one.
  bool ask_again(const Handle& handle);

  /// Takes back a request: it is not begun, or asked to stop.
  void take_back(const Handle& handle);

  /// A drawing ends. Requests that were neither made nor repeated in it are dropped; a piece that
  /// runs for such a one is asked to stop where others wait.
  void end_drawing();

 private:
  void run(const std::stop_token& stop);

  std::function<void()> wake_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::list<Handle> waiting_;  // in the order of asking
  Handle running_;
  std::uint64_t drawing_ = 1;
  std::jthread thread_;  // the last member: it uses the others
};

}  // namespace sir::viewer
