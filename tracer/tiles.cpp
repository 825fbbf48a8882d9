#include "tracer/tiles.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace sir {
namespace {

constexpr int kTile = 32;  // pixels; small enough to share the work out evenly

}  // namespace

bool for_each_tile(ImageSize size, int threads, const std::function<TileWorker()>& make_worker,
                   const std::function<void(double)>& progress, const std::stop_token& stop) {
  const int across = (size.width + kTile - 1) / kTile;
  const int tiles = across * ((size.height + kTile - 1) / kTile);
  std::atomic<int> next{0};
  std::mutex report;
  int done = 0;
  std::exception_ptr failure;

  const auto work = [&] {
    try {
      TileWorker worker;
      {
        const std::scoped_lock lock(report);
        worker = make_worker();
      }
      for (int tile = next++; tile < tiles && !stop.stop_requested(); tile = next++) {
        const int x = tile % across * kTile, y = tile / across * kTile;
        worker({x, y, std::min(kTile, size.width - x), std::min(kTile, size.height - y)});
        if (stop.stop_requested()) break;
        const std::scoped_lock lock(report);
        ++done;
        if (progress) progress(double(done) / tiles);
      }
    } catch (...) {
      const std::scoped_lock lock(report);
      failure = std::current_exception();
      next = tiles;
    }
  };
  {
    const int wanted =
        threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
    std::vector<std::jthread> pool;
    for (int i = 1; i < std::clamp(wanted, 1, std::max(tiles, 1)); ++i) pool.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  return done == tiles;
}

}  // namespace sir
