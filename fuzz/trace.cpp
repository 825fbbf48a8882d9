// Register traces: read, and played on an MA120, forward and back.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "eltek/trace_player.h"
#include "eltek/trace_text.h"
#include "fuzz/refusal.h"
#include "fuzz/targets.h"

namespace sir::fuzz {
namespace {

std::optional<eltek::Trace> parsed(std::string_view name, std::string_view text) {
  try {
    return eltek::parse_trace(std::string(name), std::string(text));
  } catch (const FileError& error) {
    check_refusal(error, name, text);
    return std::nullopt;
  }
}

// Whether a replay takes milliseconds: a few lines can ask for a thousand screens.
bool is_short(const eltek::Trace& trace) {
  constexpr std::uint64_t kMostPixels = 2 * eltek::Trace::kMaxBurst;
  constexpr int kMostFrames = 3;  // waits and power cycles, each up to a whole screen
  std::uint64_t pixels = 0;
  int frames = 0;
  for (const eltek::TraceRecord& record : trace.records()) {
    if (const auto* write = std::get_if<eltek::PixelWrite>(&record)) pixels += write->count;
    if (const auto* read = std::get_if<eltek::PixelRead>(&record)) pixels += read->count;
    frames += std::holds_alternative<eltek::Wait>(record) ||
              std::holds_alternative<eltek::PowerCycle>(record);
  }
  return pixels <= kMostPixels && frames <= kMostFrames;
}

// What a place in the trace is: all of the machine that a program can see.
struct Seen {
  std::vector<std::uint8_t> planes;
  std::array<Rgb8, 256> colours;
  std::array<int, 2> address;
  std::size_t phase;
  std::int64_t scanned;
  std::optional<std::size_t> difference;
  bool blanked;
  friend bool operator==(const Seen&, const Seen&) = default;
};

Seen look(const eltek::TracePlayer& player) {
  const eltek::Ma120& machine = player.machine();
  Seen seen{{},
            machine.seen(),
            {machine.pixel_address.column(), machine.pixel_address.row()},
            machine.lut_ports.phase(),
            player.raster().position().scanned(),
            {},
            machine.blanked};
  if (player.difference()) seen.difference = player.difference()->record;
  for (int plane = 0; plane < eltek::FrameBuffer::kPlanes; ++plane) {
    const auto bits = machine.frame_buffer.plane(plane);
    seen.planes.insert(seen.planes.end(), bits.begin(), bits.end());
  }
  return seen;
}

void play(const eltek::Trace& trace) {
  eltek::TracePlayer player(trace);
  const std::size_t middle = player.count() / 2;
  while (player.position() < middle) require(player.step(), "a trace is played to its end");
  const Seen seen = look(player);
  while (player.step()) {
  }
  require(player.position() == player.count(), "a trace is played to its end");
  player.seek(middle);
  require(look(player) == seen, "a place in a trace is the same on the way forward and back");
  for (std::size_t i = 0; i < player.count(); ++i)
    require(player.describe(i).find('\n') == std::string::npos, "a record is told in a line");
}

}  // namespace

void play_trace(Bytes bytes) {
  const auto trace = parsed("F.trace", text_of(bytes));
  if (!trace) return;
  const std::string text = eltek::trace_text(*trace);
  const auto again = parsed("again", text);
  require(again && *again == *trace, "a trace that is written reads as what it was");
  require(eltek::trace_text(*again) == text, "what is read and written is the same text");
  if (is_short(*trace)) play(*trace);
}

}  // namespace sir::fuzz
