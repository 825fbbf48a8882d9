// Artifact of a session with the MA120: every access to its registers, in order (our model; the
// thesis has no such thing).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "eltek/frame_buffer.h"
#include "eltek/port.h"
#include "quant/dac_code.h"

namespace sir::eltek {

/// A register other than Port::pixel was written.
struct PortWrite {
  Port port;
  std::uint16_t value;
  friend bool operator==(const PortWrite&, const PortWrite&) = default;
};

/// A register other than Port::pixel was read, and gave this; unknown where nobody says.
struct PortRead {
  Port port;
  std::optional<std::uint16_t> value;
  friend bool operator==(const PortRead&, const PortRead&) = default;
};

/// One index several times, 4 bytes in all.
class PixelRun {
 public:
  static constexpr std::uint32_t kMaxCount = (1u << 23) - 1;

  /// Without an index: pixels read of which nobody says what they were. `count` is 1 to kMaxCount.
  PixelRun(std::uint32_t count, std::optional<std::uint8_t> index)
      : bits_(count << 9 | (index ? 0x100u | *index : 0u)) {}

  std::uint32_t count() const { return bits_ >> 9; }
  std::optional<std::uint8_t> index() const {
    if ((bits_ & 0x100u) == 0) return std::nullopt;
    return static_cast<std::uint8_t>(bits_);
  }
  friend bool operator==(const PixelRun&, const PixelRun&) = default;

 private:
  std::uint32_t bits_;  // 23 of the count, 1 if the index is known, 8 of the index
};

/// Pixels went to, or came from, Port::pixel; `count` of them, as Trace::runs has it.
struct PixelRuns {
  std::uint32_t first_run, runs, count;
  friend bool operator==(const PixelRuns&, const PixelRuns&) = default;
};
struct PixelWrite : PixelRuns {
  friend bool operator==(const PixelWrite&, const PixelWrite&) = default;
};
struct PixelRead : PixelRuns {
  friend bool operator==(const PixelRead&, const PixelRead&) = default;
};

/// The host waited for the beam (Bus::wait).
struct Wait {
  int line;
  friend bool operator==(const Wait&, const Wait&) = default;
};

/// The machine was switched off and on (Bus::power_cycle).
struct PowerCycle {
  quant::DacBits dac;
  friend bool operator==(const PowerCycle&, const PowerCycle&) = default;
};

using TraceRecord = std::variant<PortWrite, PortRead, PixelWrite, PixelRead, Wait, PowerCycle>;

/// The records, from power-on with the given DAC. Pixels stay runs: memory goes with the number
/// of runs (4 bytes each) and records (16), not with that of pixels. Three limits keep the time
/// of a replay within seconds, whoever wrote the trace.
class Trace {
 public:
  static constexpr std::size_t kMaxRecords = std::size_t{1} << 24;
  static constexpr std::size_t kMaxRuns = std::size_t{1} << 26;
  static constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 30;  ///< over 1300 screens
  /// Of one record: the screen's. More would go over themselves.
  static constexpr std::uint32_t kMaxBurst = FrameBuffer::kColumns * FrameBuffer::kRows;

  explicit Trace(const quant::DacBits& dac = {}) : dac_(dac) {}

  const quant::DacBits& dac() const { return dac_; }
  const std::vector<TraceRecord>& records() const { return records_; }
  std::span<const PixelRun> runs(const PixelRuns& pixels) const {
    return std::span(runs_).subspan(pixels.first_run, pixels.runs);
  }

  /// Whether a record of so many runs and pixels would pass no limit. A power cycle, which clears
  /// the memory, counts as kMaxBurst pixels.
  bool has_room_for(std::size_t runs, std::uint64_t pixels) const {
    return records_.size() < kMaxRecords && runs <= kMaxRuns - runs_.size() &&
           pixels <= kMaxPixels - pixels_;
  }

  /// Adds records; std::length_error where there is no room, and for more pixels than kMaxBurst.
  void add(const TraceRecord& record);
  void add_pixel_write(std::span<const PixelRun> runs);
  void add_pixel_read(std::span<const PixelRun> runs);

  /// Another DAC for the start, while there are no records.
  void set_dac(const quant::DacBits& dac) { dac_ = dac; }

  friend bool operator==(const Trace&, const Trace&) = default;

 private:
  PixelRuns keep(std::span<const PixelRun> runs);

  quant::DacBits dac_;
  std::vector<TraceRecord> records_;
  std::vector<PixelRun> runs_;
  std::uint64_t pixels_ = 0;
};

}  // namespace sir::eltek
