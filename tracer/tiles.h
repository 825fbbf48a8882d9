// Sharing an image out among threads (SIR's loop over the pixels, thesis 3.3).
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>

#include "tracer/planes.h"

namespace sir {

/// A rectangle of pixels, from the top left.
struct Region {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Works on one of many pieces, by its number; belongs to one thread.
using PieceWorker = std::function<void(std::int64_t piece)>;

/// Hands the pieces 0..count-1 to `threads` workers (0: as many as cores; never more than
/// pieces), each made by `make_worker`, one call at a time. `progress`, if given, is
/// called from any thread, one call at a time, with the share of the pieces done, in
/// [0,1]. After a stop request no piece is begun; a worker that takes long should look
/// at the token itself. True where all pieces were done before any stop. What a worker
/// throws ends the work and is thrown again.
bool for_each_piece(std::int64_t count, int threads,
                    const std::function<PieceWorker()>& make_worker,
                    const std::function<void(double)>& progress, const std::stop_token& stop);

/// Works on one tile; belongs to one thread.
using TileWorker = std::function<void(const Region& tile)>;

/// for_each_piece() with an image's tiles for pieces.
bool for_each_tile(ImageSize size, int threads, const std::function<TileWorker()>& make_worker,
                   const std::function<void(double)>& progress, const std::stop_token& stop);

}  // namespace sir
