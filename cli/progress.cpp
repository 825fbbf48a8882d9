#include "cli/progress.h"

#include <unistd.h>

#include <cstdio>

namespace sir::cli {

using std::chrono::duration;
using std::chrono::steady_clock;

Progress::Progress(const Session& session, std::string label)
    : label_(std::move(label)),
      enabled_(!session.quiet && isatty(STDERR_FILENO) == 1),
      start_(steady_clock::now()),
      last_(start_) {}

std::function<void(double)> Progress::callback() {
  if (!enabled_) return {};
  return [this](double done) { show(done); };
}

void Progress::show(double done) {
  const auto now = steady_clock::now();
  constexpr double kInterval = 0.1, kPatience = 0.5;  // seconds
  const double elapsed = duration<double>(now - start_).count();
  if (elapsed < kPatience || duration<double>(now - last_).count() < kInterval) return;
  last_ = now;
  const double taken = taken_share_ ? done * taken_share_() : 0;
  const double left = done > taken ? elapsed * (1 - done) / (done - taken) : 0;
  std::fprintf(stderr, "\r%s: %3.0f %%", label_.c_str(), done * 100);
  if (taken > 0) std::fprintf(stderr, " (%.0f %% taken over)", taken * 100);
  std::fprintf(stderr, ", %.0f s left \x1b[K", left);
  shown_ = true;
}

void Progress::finish() {
  if (shown_) std::fprintf(stderr, "\r\x1b[K");
  shown_ = false;
}

}  // namespace sir::cli
