#include "eltek/trace_player.h"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <utility>

namespace sir::eltek {
namespace {

constexpr std::size_t kStates = 16;
constexpr std::uint64_t kLeastWay = 8 * std::uint64_t{Trace::kMaxBurst};

// What playing a record costs, in pixels.
std::uint64_t cost(const TraceRecord& record) {
  constexpr std::uint64_t kOfAny = 16;
  std::uint64_t pixels = 0;
  if (const auto* written = std::get_if<PixelWrite>(&record)) pixels = written->count;
  if (const auto* read = std::get_if<PixelRead>(&record)) pixels = read->count;
  return kOfAny + pixels;
}

}  // namespace

// Puts a record on the bus.
struct TracePlayer::Play {
  TracePlayer& player;
  Bus& bus = player.bus_;

  void operator()(const PortWrite& write) { bus.write(write.port, write.value); }
  void operator()(const PortRead& read) {
    const std::uint16_t found = bus.read(read.port);
    if (read.value) compare(read.port, *read.value, found);
  }
  void operator()(const PixelWrite& pixels) {
    // Short runs go together: neighbouring pixels are written eight at a time.
    constexpr std::uint32_t kShort = 64;
    std::array<std::uint8_t, 1024> row;
    std::size_t filled = 0;
    const auto send = [&] {
      bus.write_pixels(std::span(row).first(filled));
      filled = 0;
    };
    for (const PixelRun& run : player.trace_.runs(pixels)) {
      const std::uint8_t index = run.index().value_or(0);
      if (filled + std::min(run.count(), kShort) > row.size()) send();
      if (run.count() > kShort) {
        send();
        bus.fill_pixels(index, run.count());
      } else {
        std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(filled), run.count(), index);
        filled += run.count();
      }
    }
    send();
  }
  void operator()(const PixelRead& pixels) {
    std::array<std::uint8_t, 1024> found;
    for (const PixelRun& run : player.trace_.runs(pixels))
      for (std::size_t rest = run.count(); rest > 0;) {
        const auto part = std::span(found).first(std::min(rest, found.size()));
        bus.read_pixels(part);
        rest -= part.size();
        if (const auto index = run.index())
          for (const std::uint8_t one : part) compare(Port::pixel, *index, one);
      }
  }
  void operator()(const Wait& wait) { bus.wait(wait.line); }
  void operator()(const PowerCycle& power) { bus.power_cycle(power.dac); }

 private:
  void compare(Port port, int expected, int found) {
    if (expected != found && !player.difference_)
      player.difference_ = {player.position_, port, expected, found};
  }
};

TracePlayer::TracePlayer(Trace trace)
    : trace_(std::move(trace)),
      describe_(trace_),
      machine_(trace_.dac()),
      raster_(machine_),
      bus_(machine_, &raster_) {
  plan();
  save();
}

void TracePlayer::plan() {
  std::uint64_t whole = 0;
  for (const TraceRecord& record : trace_.records()) whole += cost(record);
  const std::uint64_t way = std::max(whole / kStates, kLeastWay);
  std::uint64_t since = 0;
  RasterPosition raster;
  stops_.push_back(0);
  for (std::size_t i = 0; i < count(); ++i) {
    const TraceRecord& record = trace_.records()[i];
    if (const auto* wait = std::get_if<Wait>(&record)) raster.advance_to(wait->line);
    if (std::holds_alternative<PowerCycle>(record)) raster.restart();
    if (raster.scanned() != (scanned_.empty() ? 0 : scanned_.back().lines))
      scanned_.push_back({i + 1, raster.scanned()});
    since += cost(record);
    if (since < way || stops_.size() > kStates) continue;
    stops_.push_back(i + 1);
    since = 0;
  }
}

bool TracePlayer::step() {
  if (position_ == count()) return false;
  seek(position_ + 1);
  return true;
}

void TracePlayer::seek(std::size_t records) {
  if (records > count()) throw std::out_of_range("a trace of fewer records");
  // The last state from which the way is shortest: one that is kept, or this.
  auto from = states_.rbegin();
  while (from->position > records) ++from;
  if (records < position_ || from->position > position_) {
    position_ = from->position;
    machine_ = from->machine;
    raster_ = from->raster;
    difference_ = from->difference;
  }
  while (states_.size() < stops_.size() && stops_[states_.size()] <= records) {
    run_to(stops_[states_.size()]);
    save();
  }
  run_to(records);
}

void TracePlayer::run_to(std::size_t records) {
  // What the beam passed a frame before the end or earlier, it has passed again since.
  raster_.paint_from(scanned_after(records) - kTiming.lines);
  for (; position_ < records; ++position_) std::visit(Play{*this}, trace_.records()[position_]);
}

std::int64_t TracePlayer::scanned_after(std::size_t records) const {
  const auto next = std::upper_bound(
      scanned_.begin(), scanned_.end(), records,
      [](std::size_t wanted, const Scanned& scanned) { return wanted < scanned.records; });
  return next == scanned_.begin() ? 0 : std::prev(next)->lines;
}

void TracePlayer::save() { states_.push_back({position_, machine_, raster_, difference_}); }

}  // namespace sir::eltek
