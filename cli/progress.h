// Progress with time left, on a terminal only.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "cli/session.h"

namespace sir::cli {

/// One line on standard error that is written over while the work goes on and
/// removed at its end. Silent with -q or where standard error is no terminal.
class Progress {
 public:
  Progress(const Session& session, std::string label);
  ~Progress() { finish(); }

  /// To be called with the share done, in [0,1]; not from two threads at once.
  std::function<void(double)> callback();

  /// Tells, of what is done, the share that an earlier run did, in [0,1]: the line says so, and the
  /// time left is reckoned without it.
  void take_over(std::function<double()> share) { taken_share_ = std::move(share); }

  /// Removes the line.
  void finish();

 private:
  void show(double done);

  std::string label_;
  std::function<double()> taken_share_;
  bool enabled_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace sir::cli
