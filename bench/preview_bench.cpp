// How long a person who models waits for the preview: the first picture and the whole one after a
// change, as the solid alone and with all that can be laid over it, and how soon what is under way
// is given up. `preview_bench [THREADS]`, 0 (all cores) if not told, from the project's folder.
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <stdexcept>

#include "bench/timing.h"
#include "modeler/csg.h"
#include "modeler/preview.h"
#include "tracer/scene_file.h"

namespace {

using namespace sir::modeler;
using Clock = std::chrono::steady_clock;

const int kRuns = sir::bench::rounds(21);

// A preview that can be waited for.
class Watched {
 public:
  explicit Watched(int threads) : preview([this] { wake(); }, threads) {}

  // Ms from `start` until the condition holds; it is looked at whenever there is news.
  template <typename Condition>
  double until(Clock::time_point start, Condition holds) {
    while (!holds()) {
      std::unique_lock lock(mutex_);
      woken_.wait(lock, [this] { return news_; });
      news_ = false;
      lock.unlock();
      if (const std::string reason = preview.error(); !reason.empty())
        throw std::runtime_error(reason);
    }
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  }

 private:
  void wake() {
    const std::scoped_lock lock(mutex_);
    news_ = true;
    woken_.notify_one();
  }
  std::mutex mutex_;
  std::condition_variable woken_;
  bool news_ = false;

 public:
  Preview preview;  // the last member: its thread wakes the others
};

struct Waits {
  std::vector<double> first, whole, abort;
};

Waits wait_for(Watched& watched, const PreviewRequest& request) {
  Waits waits;
  for (int run = 0; run < kRuns; ++run) {
    auto start = Clock::now();
    std::uint64_t number = watched.preview.request(request);
    waits.first.push_back(watched.until(start, [&] {
      const auto picture = watched.preview.take();
      return picture && picture->request == number;
    }));
    waits.whole.push_back(watched.until(start, [&] {
      const auto picture = watched.preview.take();
      return picture && picture->request == number && picture->whole;
    }));
    watched.until(start, [&] { return !watched.preview.busy(); });
    // Given up at another place each time.
    start = Clock::now();
    number = watched.preview.request(request);
    const double part = waits.whole.back() * (run + 0.5) / kRuns;
    while (std::chrono::duration<double, std::milli>(Clock::now() - start).count() < part)
      std::this_thread::yield();
    start = Clock::now();
    watched.preview.cancel();
    waits.abort.push_back(watched.until(start, [&] { return !watched.preview.busy(); }));
  }
  return waits;
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

void print(const char* scene, const char* what, const Waits& waits) {
  using sir::bench::median;
  std::printf("%-9s %-8s %8.1f %8.1f %8.2f %8.2f\n", scene, what, median(waits.first),
              median(waits.whole), median(waits.abort), largest(waits.abort));
}

}  // namespace

int main(int count, char** words) try {
  Watched watched(count > 1 ? std::atoi(words[1]) : 0);
  std::printf("640x480, ms, median of %d\n", kRuns);
  std::printf("%-9s %-8s %8s %8s %8s %8s\n", "scene", "shown", "first", "whole", "abort", "worst");
  for (const char* name : {"calice", "lcg", "luminar", "piramide", "whitted"}) {
    const sir::Scene scene = sir::read_scene(std::string("images/") + name);
    PreviewRequest request;
    request.solid = from_csg(scene.tree);
    request.camera = scene.camera;
    request.lighting = scene.lighting;
    request.surfaces = scene.surfaces;
    print(name, "alone", wait_for(watched, request));
    request.ghosts = request.silhouette = true;
    for (const auto& lines :
         {axes(request.solid->bounds), edges(request.solid->bounds), grid(request.solid->bounds)})
      request.guides.insert(request.guides.end(), lines.begin(), lines.end());
    print(name, "overlaid", wait_for(watched, request));
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "preview_bench: %s\n", error.what());
  return 1;
}
