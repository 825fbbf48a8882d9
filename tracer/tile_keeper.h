// What a long render leaves in other hands as it goes, so that it can be continued after it was
// ended (SIR's loop over the pixels, thesis 3.3).
//
// A tile, here, is the piece of a render that one thread finishes by itself:
// - one ray a pixel: a square of 32x32 pixels;
// - adaptive antialiasing, and progressive pictures: 256 samples that were asked for together.
//   Which samples are asked for hangs on those before, and on nothing else; so a render that is
//   given the samples of the first one asks for the same ones again;
// - random antialiasing: the pixels of 2^16 samples, shared out among all threads.
#pragma once

#include <compare>
#include <cstdint>
#include <span>

#include "tracer/planes.h"
#include "tracer/ray_counts.h"

namespace sir {

/// Which tile of a render: the same in every run with the same settings, with any number of
/// threads.
struct TileId {
  std::uint32_t stage = 0;  ///< counts what is traced one after another
  std::uint64_t first = 0;  ///< its first pixel or sample within the stage
  friend auto operator<=>(const TileId&, const TileId&) = default;
};

/// Given to a render in its options. Called from any of its threads, at the same time.
class TileKeeper {
 public:
  virtual ~TileKeeper() = default;

  /// The bytes of a tile that was finished in an earlier run; false where it was not, and then it
  /// is traced.
  virtual bool take(const TileId& tile, std::span<Rgb8> colours) = 0;

  /// A tile that has been finished, and what it cost.
  virtual void keep(const TileId& tile, std::span<const Rgb8> colours, const RayCounts& cost) = 0;

  /// What all tiles taken so far had cost.
  virtual RayCounts taken_counts() const = 0;
};

}  // namespace sir
