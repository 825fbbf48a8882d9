// Plays a trace on an MA120 of its own, forward and back (our model; the thesis has no such
// thing).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "eltek/bus.h"
#include "eltek/ma120.h"
#include "eltek/raster.h"
#include "eltek/trace_describe.h"
#include "eltek/trace_record.h"

namespace sir::eltek {

/// A read that gave something else than the trace says.
struct ReadDifference {
  std::size_t record = 0;  ///< from 0
  Port port = Port::pixel;
  int expected = 0, found = 0;
};

/// Back is played from the last of the states that it keeps: at most 16, where the way so far has
/// grown by a 16th of the whole, and the one at power-on; 1.6 MB each (planes and tube), and up
/// to 0.6 MB of palettes where every line has its own. A short trace, of 8 screens of pixels or
/// less, needs none but the first.
class TracePlayer {
 public:
  /// At power-on, before the first record.
  explicit TracePlayer(Trace trace);
  TracePlayer(const TracePlayer&) = delete;
  TracePlayer& operator=(const TracePlayer&) = delete;

  /// Records of the trace, and those played.
  std::size_t count() const { return trace_.records().size(); }
  std::size_t position() const { return position_; }

  /// Plays one record; false at the end.
  bool step();

  /// Goes to where so many records are played, forward or back. Throws std::out_of_range for more
  /// than count().
  void seek(std::size_t records);

  /// What a record did, in one line (TraceDescriber).
  std::string describe(std::size_t record) const { return describe_(record); }

  const Trace& trace() const { return trace_; }

  /// The machine and its beam after the records played.
  const Ma120& machine() const { return machine_; }
  const Raster& raster() const { return raster_; }

  /// The first of the reads played that differed from the trace.
  const std::optional<ReadDifference>& difference() const { return difference_; }

 private:
  struct State {
    std::size_t position;
    Ma120 machine;
    Raster raster;
    std::optional<ReadDifference> difference;
  };
  struct Play;

  void plan();
  void run_to(std::size_t records);
  std::int64_t scanned_after(std::size_t records) const;
  void save();

  Trace trace_;
  TraceDescriber describe_;
  Ma120 machine_;
  Raster raster_;
  Bus bus_;
  std::size_t position_ = 0;
  std::optional<ReadDifference> difference_;
  std::vector<std::size_t> stops_;  // where states are to be kept, ascending
  std::vector<State> states_;       // those kept so far, the first ones of stops_
  // Where the beam moves: records played and lines scanned after them, ascending.
  struct Scanned {
    std::size_t records;
    std::int64_t lines;
  };
  std::vector<Scanned> scanned_;
};

}  // namespace sir::eltek
