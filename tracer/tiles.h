// Sharing an image out among threads (SIR's loop over the pixels, thesis 3.3).
#pragma once

#include <functional>
#include <stop_token>

#include "tracer/planes.h"

namespace sir {

/// A rectangle of pixels, from the top left.
struct Region {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Works on one tile; belongs to one thread.
using TileWorker = std::function<void(const Region& tile)>;

/// Cuts an image into tiles and hands them to `threads` workers (0: as many as
/// cores), each made by `make_worker`, one call at a time. `progress`, if given,
/// is called from any thread, one call at a time, with the share of the tiles
/// done, in [0,1]. After a stop request no tile is begun; a worker that takes
/// long should look at the token itself. True where all tiles were done before
/// any stop. What a worker throws ends the work and is thrown again.
bool for_each_tile(ImageSize size, int threads, const std::function<TileWorker()>& make_worker,
                   const std::function<void(double)>& progress, const std::stop_token& stop);

}  // namespace sir
