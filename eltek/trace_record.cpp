#include "eltek/trace_record.h"

#include <stdexcept>

namespace sir::eltek {

void Trace::add(const TraceRecord& record) {
  const std::uint64_t cleared = std::holds_alternative<PowerCycle>(record) ? kMaxBurst : 0;
  if (!has_room_for(0, cleared)) throw std::length_error("a trace of too many records");
  pixels_ += cleared;
  records_.push_back(record);
}

void Trace::add_pixel_write(std::span<const PixelRun> runs) {
  const PixelRuns kept = keep(runs);
  add(PixelWrite{kept});
}

void Trace::add_pixel_read(std::span<const PixelRun> runs) {
  const PixelRuns kept = keep(runs);
  add(PixelRead{kept});
}

PixelRuns Trace::keep(std::span<const PixelRun> runs) {
  std::uint64_t count = 0;
  for (const PixelRun& run : runs) count += run.count();
  if (count > kMaxBurst || !has_room_for(runs.size(), count))
    throw std::length_error("a trace of too many pixels");
  const PixelRuns kept{static_cast<std::uint32_t>(runs_.size()),
                       static_cast<std::uint32_t>(runs.size()), static_cast<std::uint32_t>(count)};
  runs_.insert(runs_.end(), runs.begin(), runs.end());
  pixels_ += count;
  return kept;
}

}  // namespace sir::eltek
