// A trace's records in words (our model; the thesis has no such thing).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "eltek/lut_ports.h"
#include "eltek/pixel_address.h"
#include "eltek/raster_position.h"
#include "eltek/trace_record.h"

namespace sir::eltek {

/// Says what each record did, which takes the state before it: to which entry and primary a byte
/// for the LUT went, where pixels began. It refers to the trace, which outlives it, and keeps the
/// small part of the state (no pixels) at every 4096th record, 0.8 kB each.
class TraceDescriber {
 public:
  explicit TraceDescriber(const Trace& trace);

  /// One line, such as "LUT entry 77: blue 12, now 63 63 12" or "1024 pixels from column 0, row
  /// 5". Throws std::out_of_range for a record that is not there.
  std::string operator()(std::size_t record) const;

  /// The state that addresses depend on.
  struct State {
    LutPorts lut;
    PixelAddress pixel;
    RasterPosition raster;
  };

 private:
  const Trace& trace_;
  std::vector<State> states_;
};

}  // namespace sir::eltek
