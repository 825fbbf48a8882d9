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

bool for_each_piece(std::int64_t count, int threads,
                    const std::function<PieceWorker()>& make_worker,
                    const std::function<void(double)>& progress, const std::stop_token& stop) {
  std::atomic<std::int64_t> next{0};
  std::mutex report;
  std::int64_t done = 0;
  std::exception_ptr failure;

  const auto work = [&] {
    try {
      PieceWorker worker;
      {
        const std::scoped_lock lock(report);
        worker = make_worker();
      }
      for (auto piece = next++; piece < count && !stop.stop_requested(); piece = next++) {
        worker(piece);
        if (stop.stop_requested()) break;
        const std::scoped_lock lock(report);
        ++done;
        if (progress) progress(double(done) / double(count));
      }
    } catch (...) {
      const std::scoped_lock lock(report);
      failure = std::current_exception();
      next = count;
    }
  };
  {
    const int wanted =
        threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
    const std::int64_t most = std::max<std::int64_t>(count, 1);
    std::vector<std::jthread> pool;
    for (int i = 1; i < std::clamp<std::int64_t>(wanted, 1, most); ++i) pool.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  return done == count;
}

bool for_each_tile(ImageSize size, int threads, const std::function<TileWorker()>& make_worker,
                   const std::function<void(double)>& progress, const std::stop_token& stop) {
  const int across = (size.width + kTile - 1) / kTile;
  const int tiles = across * ((size.height + kTile - 1) / kTile);
  const auto make_piece_worker = [&]() -> PieceWorker {
    return [&, worker = make_worker()](std::int64_t piece) {
      const int tile = static_cast<int>(piece);
      const int x = tile % across * kTile, y = tile / across * kTile;
      worker({x, y, std::min(kTile, size.width - x), std::min(kTile, size.height - y)});
    };
  };
  return for_each_piece(tiles, threads, make_piece_worker, progress, stop);
}

}  // namespace sir
