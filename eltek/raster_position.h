// Where the beam is (our model; see frame_timing.h).
#pragma once

#include <cstdint>
#include <stdexcept>

#include "eltek/frame_timing.h"

namespace sir::eltek {

/// Throws std::out_of_range for a line that no frame has: 0 to kTiming.lines - 1 are there, those
/// from FrameBuffer::kRows on in the vertical blanking.
inline void require_line(int line) {
  if (line < 0 || line >= kTiming.lines) throw std::out_of_range("a line outside the frame");
}

/// Counts the lines that have been scanned since power-on, blanking included.
class RasterPosition {
 public:
  std::int64_t scanned() const { return scanned_; }

  /// The line that comes next.
  int line() const { return static_cast<int>(scanned_ % kTiming.lines); }

  /// Frames that are over.
  std::int64_t frames() const { return scanned_ / kTiming.lines; }

  /// On to a line of this frame, or of the next one where it is over already. Nothing happens
  /// where that line comes next anyway. Throws as require_line.
  void advance_to(int line) {
    require_line(line);
    scanned_ += line - this->line() + (line < this->line() ? kTiming.lines : 0);
  }

  /// On to the start of a frame.
  void restart() { advance_to(0); }

  friend bool operator==(const RasterPosition&, const RasterPosition&) = default;

 private:
  std::int64_t scanned_ = 0;
};

}  // namespace sir::eltek
