#include "cli/show_trace.h"

#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "cli/image_input.h"
#include "cli/output_path.h"
#include "eltek/trace_text.h"
#include "eltek/transfer.h"
#include "tracer/atomic_file.h"
#include "tracer/error.h"
#include "tracer/text_file.h"
#include "viewer/image_name.h"
#include "viewer/rendition.h"
#include "viewer/station.h"

namespace sir::cli {

void check_trace(const ShowOptions& options) {
  if (!options.trace) return;
  for (const auto& input : options.inputs) {
    refuse_input_file(*options.trace, input);
    const auto lut = viewer::lut_file(viewer::base_name(input), {options.map, options.lut});
    if (lut) refuse_same_file(*options.trace, *lut);
  }
  if (options.png && same_place(*options.trace, *options.png))
    throw FileError(options.trace->string(), 0, "both the trace and the picture would go there");
  require_writable(*options.trace);  // a session would be lost
}

void save_trace(AtomicFiles& files, const ShowOptions& options,
                const eltek::TraceRecorder& recorder, const Session& session) {
  if (options.trace) eltek::write_trace(files.add(*options.trace), recorder.trace());
  files.commit();
  if (!options.trace) return;
  const std::string records = counted(recorder.trace().records().size(), "record");
  if (recorder.full())
    note(session, options.trace->string() + ": holds the session's first " + records +
                      "; a trace takes no more");
  else detail(session, "wrote " + options.trace->string() + ", " + records);
}

void report_transfer(const ShownImage& image, const ShowOptions& options) {
  if (options.bus_rate <= 0) return;
  eltek::BusTally tally;
  viewer::Station station(options.crop);
  station.add_listener(tally);
  station.show(image.picture.input.string(), image.picture.planes.size, image.rendition);
  const eltek::Transfer transfer{tally.bytes(), options.bus_rate};
  const std::uint64_t lut =
      tally.bytes(eltek::Port::lut_write) + tally.bytes(eltek::Port::lut_data);
  const std::uint64_t pixels = tally.bytes(eltek::Port::pixel);
  print(fmt::format(
      "{}: {} bytes on the bus: LUT {}, pixels {}, other registers {}\n"
      "  at {:.15g} bytes/s {:.4g} s, {:.4g} frames of the screen\n",
      image.picture.base.string(), tally.bytes(), lut, pixels, tally.bytes() - lut - pixels,
      transfer.rate, transfer.seconds(), transfer.frames()));
}

}  // namespace sir::cli
