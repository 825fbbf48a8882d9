// How long a person waits for a picture after opening a scene: the coarse one, the whole, and its
// first rendition. `workshop_bench [BASE]`, images/whitted if not told, from the project's folder.
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <mutex>
#include <stdexcept>

#include "bench/timing.h"
#include "viewer/workshop.h"

namespace {

using sir::viewer::Method;
using sir::viewer::Workshop;

struct Waits {
  double first = 0, whole = 0, median = 0, best = 0;  // ms since opening
};

Waits open_once(const char* base) {
  std::mutex mutex;
  std::condition_variable woken;
  bool news = false;
  sir::viewer::WorkshopOptions options;
  options.wake = [&] {
    const std::scoped_lock lock(mutex);
    news = true;
    woken.notify_one();
  };
  Workshop workshop(options);
  const auto start = std::chrono::steady_clock::now();
  const std::size_t number = workshop.open(base);
  const auto wait_until = [&](auto reached) {
    while (!reached()) {
      std::unique_lock lock(mutex);
      woken.wait(lock, [&] { return news; });
      news = false;
      if (const auto state = workshop.state(number); state.failed)
        throw std::runtime_error(state.message);
    }
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
  };
  Waits waits;
  waits.first = wait_until([&] { return workshop.state(number).picture != nullptr; });
  waits.median =
      wait_until([&] { return workshop.shown(number, Method::hsv_median).rendition != nullptr; });
  waits.whole = wait_until([&] { return !workshop.state(number).busy; });
  waits.best = wait_until([&] { return workshop.shown(number, Method::best).current; });
  return waits;
}

}  // namespace

int main(int count, char** words) try {
  const int kRuns = sir::bench::rounds(11);
  const char* base = count > 1 ? words[1] : "images/whitted";
  std::vector<double> first, through_lut, whole, best;
  for (int i = 0; i < kRuns; ++i) {
    const Waits waits = open_once(base);
    first.push_back(waits.first);
    through_lut.push_back(waits.median);
    whole.push_back(waits.whole);
    best.push_back(waits.best);
  }
  using sir::bench::median;
  std::printf("%s, 640x480, ms after opening, median of %d\n", base, kRuns);
  std::printf("first picture             %8.1f\n", median(first));
  std::printf("the same, median in hsv   %8.1f\n", median(through_lut));
  std::printf("whole picture             %8.1f\n", median(whole));
  std::printf("the same, best            %8.1f\n", median(best));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "workshop_bench: %s\n", error.what());
  return 1;
}
