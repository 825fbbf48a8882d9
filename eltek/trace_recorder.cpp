#include "eltek/trace_recorder.h"

#include <algorithm>

namespace sir::eltek {
namespace {

// So that no line of the text gets longer than TextFile reads.
constexpr std::size_t kMaxRunsOfRecord = std::size_t{1} << 16;

}  // namespace

void TraceRecorder::wrote(Port port, std::uint16_t value) { add(PortWrite{port, value}); }

void TraceRecorder::read(Port port, std::uint16_t value) { add(PortRead{port, value}); }

void TraceRecorder::wrote_pixels(std::span<const std::uint8_t> indices) { collect(indices, true); }

void TraceRecorder::read_pixels(std::span<const std::uint8_t> indices) { collect(indices, false); }

void TraceRecorder::filled_pixels(std::uint8_t index, std::size_t count) {
  while (count > 0 && !full_) {
    const auto part = static_cast<std::uint32_t>(std::min<std::size_t>(count, Trace::kMaxBurst));
    runs_.emplace_back(part, index);
    pixels_ = part;
    flush(true);
    count -= part;
  }
}

void TraceRecorder::waited(int line) { add(Wait{line}); }

void TraceRecorder::power_cycled(const quant::DacBits& dac) {
  if (trace_.records().empty()) trace_.set_dac(dac);
  else add(PowerCycle{dac});
}

void TraceRecorder::add(const TraceRecord& record) {
  const bool clears = std::holds_alternative<PowerCycle>(record);
  full_ = full_ || !trace_.has_room_for(0, clears ? Trace::kMaxBurst : 0);
  if (!full_) trace_.add(record);
}

void TraceRecorder::collect(std::span<const std::uint8_t> indices, bool written) {
  for (std::size_t i = 0; i < indices.size() && !full_;) {
    std::size_t end = i + 1;
    const std::size_t most = std::min<std::size_t>(indices.size(), i + Trace::kMaxBurst - pixels_);
    while (end < most && indices[end] == indices[i]) ++end;
    runs_.emplace_back(static_cast<std::uint32_t>(end - i), indices[i]);
    pixels_ += static_cast<std::uint32_t>(end - i);
    i = end;
    if (pixels_ == Trace::kMaxBurst || runs_.size() == kMaxRunsOfRecord) flush(written);
  }
  flush(written);
}

void TraceRecorder::flush(bool written) {
  if (!runs_.empty()) {
    full_ = full_ || !trace_.has_room_for(runs_.size(), pixels_);
    if (!full_) written ? trace_.add_pixel_write(runs_) : trace_.add_pixel_read(runs_);
  }
  runs_.clear();
  pixels_ = 0;
}

}  // namespace sir::eltek
