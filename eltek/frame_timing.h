// How long the MA120 takes to scan a frame (our model; the thesis gives 1024x780 alone, 3.4).
#pragma once

#include "eltek/frame_buffer.h"

namespace sir::eltek {

/// Line 0 begins at the start of a frame; behind the 780 lines that are seen comes the vertical
/// blanking, behind the 1024 columns of each line the horizontal one. The numbers are ours, such
/// as monitors of 1024x768 had at the end of the eighties: 65 MHz, 48.9 kHz, 60 Hz without
/// interlace; 4.7 us of each line and 0.74 ms of each frame are blanking.
struct FrameTiming {
  double pixel_clock = 65e6;  ///< Hz
  int columns = 1328;         ///< in all, at least FrameBuffer::kColumns
  int lines = 816;            ///< in all, at least FrameBuffer::kRows

  constexpr double line_seconds() const { return columns / pixel_clock; }
  constexpr double frame_seconds() const { return line_seconds() * lines; }
  constexpr double line_rate() const { return 1 / line_seconds(); }
  constexpr double refresh() const { return 1 / frame_seconds(); }

  /// The line, 0 to lines-1, that is being scanned so many seconds after the start of a frame,
  /// that one or any later. Throws std::invalid_argument for a time that is negative or not
  /// finite.
  int line_at(double seconds) const;
};

/// The MA120's.
inline constexpr FrameTiming kTiming{};
static_assert(kTiming.columns >= FrameBuffer::kColumns && kTiming.lines >= FrameBuffer::kRows);

}  // namespace sir::eltek
