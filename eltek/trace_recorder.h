// Collects the trace of a session on the bus (our model; the thesis has no such thing).
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "eltek/bus_listener.h"
#include "eltek/trace_record.h"

namespace sir::eltek {

/// Listens to a bus from the machine's power-on; pixels are kept as runs. A burst longer than a
/// record may be becomes several records, which is the same to the machine. A power cycle that
/// comes before anything else says the DAC at the start.
///
/// Where a limit of Trace is reached recording stops, which full() tells; what was recorded until
/// then is a trace like any other.
class TraceRecorder : public BusListener {
 public:
  explicit TraceRecorder(const quant::DacBits& dac = {}) : trace_(dac) {}

  void wrote(Port port, std::uint16_t value) override;
  void read(Port port, std::uint16_t value) override;
  void wrote_pixels(std::span<const std::uint8_t> indices) override;
  void filled_pixels(std::uint8_t index, std::size_t count) override;
  void read_pixels(std::span<const std::uint8_t> indices) override;
  void waited(int line) override;
  void power_cycled(const quant::DacBits& dac) override;

  const Trace& trace() const { return trace_; }
  bool full() const { return full_; }

 private:
  void add(const TraceRecord& record);
  void collect(std::span<const std::uint8_t> indices, bool written);
  void flush(bool written);

  Trace trace_;
  std::vector<PixelRun> runs_;  // of the record that is being collected
  std::uint32_t pixels_ = 0;    // in them
  bool full_ = false;
};

}  // namespace sir::eltek
