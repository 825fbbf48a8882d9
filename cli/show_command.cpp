#include "cli/show_command.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/image_input.h"
#include "cli/interrupt.h"
#include "cli/output_path.h"
#include "eltek/display_driver.h"
#include "eltek/trace_recorder.h"
#include "eltek/trace_text.h"
#include "eltek/transfer.h"
#include "quant/choose.h"
#include "quant/dac_parse.h"
#include "quant/map_image.h"
#include "tracer/atomic_file.h"
#include "tracer/error.h"
#include "tracer/scene_path.h"
#include "tracer/text_file.h"
#include "viewer/png_file.h"
#include "viewer/screen_view.h"
#ifdef SIR_WITH_SDL
#include "viewer/window.h"
#endif

namespace sir::cli {
namespace {

// --lut, else BASE.LUT or BASE.lut where there is one.
std::optional<std::filesystem::path> lut_file(const ShowOptions& options,
                                              const std::filesystem::path& base) {
  if (options.lut) return options.lut;
  for (const char* suffix : {"LUT", "lut"})
    if (auto path = with_suffix(base, suffix); std::filesystem::exists(path)) return path;
  return std::nullopt;
}

viewer::ShownImage prepare(const std::filesystem::path& input, const ShowOptions& options,
                           const Session& session) {
  const Planes planes = load_image(input, options.size);
  // An image that does not fit is refused before a LUT is sought for it.
  eltek::place(input.string(), planes.size,
               options.crop ? eltek::Oversize::crop : eltek::Oversize::refuse);
  viewer::ShownImage image;
  image.base = base_name(input);
  image.size = planes.size;
  if (const auto path = lut_file(options, image.base)) {
    for (const auto& output : {options.png, options.trace})
      if (output) refuse_same_file(*output, *path);
    image.lut = quant::read_lut(*path);
    image.lut_name = path->filename().string();
    detail(session, input.string() + ": shown with " + path->string());
  } else {
    image.lut = quant::choose_lut(planes);
    image.lut_name = "chosen by median in hsv";
    note(session, input.string() + ": there is no " + with_suffix(image.base, "LUT").string() +
                      "; shown with a LUT chosen by median in hsv");
  }
  if (image.lut.dac != quant::DacBits{})
    note(session, input.string() + ": shown through a DAC of " + quant::bits_text(image.lut.dac) +
                      " bits, which the MA120 did not have");
  image.reserved = options.map.reserved;
  image.indices = quant::map_image(planes, image.lut, options.map);
  return image;
}

// Before anything is done for it.
void check_trace(const ShowOptions& options) {
  if (!options.trace) return;
  for (const auto& input : options.inputs) refuse_input_file(*options.trace, input);
  if (options.lut) refuse_same_file(*options.trace, *options.lut);
  if (options.png && same_place(*options.trace, *options.png))
    throw FileError(options.trace->string(), 0, "both the trace and the picture would go there");
}

void save_trace(const ShowOptions& options, const eltek::TraceRecorder& recorder,
                const Session& session) {
  if (!options.trace) return;
  eltek::write_trace(*options.trace, recorder.trace());
  const std::string records = counted(recorder.trace().records().size(), "record");
  if (recorder.full())
    note(session, options.trace->string() + ": holds the session's first " + records +
                      "; a trace takes no more");
  else detail(session, "wrote " + options.trace->string() + ", " + records);
}

// What the display program sends for an image, counted where it is sent.
void report_transfer(const viewer::ShownImage& image, const ShowOptions& options) {
  eltek::Ma120 machine(image.lut.dac);
  eltek::Bus bus(machine);
  eltek::BusTally tally;
  bus.add_listener(tally);
  show_image(bus, {image.base.string(), image.size, image.indices}, image.lut,
             options.crop ? eltek::Oversize::crop : eltek::Oversize::refuse, image.reserved);
  const eltek::Transfer transfer{tally.bytes(), options.bus_rate};
  const std::uint64_t lut =
      tally.bytes(eltek::Port::lut_write) + tally.bytes(eltek::Port::lut_data);
  const std::uint64_t pixels = tally.bytes(eltek::Port::pixel);
  print(
      fmt::format("{}: {} bytes on the bus: LUT {}, pixels {}, other registers {}\n"
                  "  at {:.15g} bytes/s {:.4g} s, {:.4g} frames of the screen\n",
                  image.base.string(), tally.bytes(), lut, pixels, tally.bytes() - lut - pixels,
                  transfer.rate, transfer.seconds(), transfer.frames()));
}

int write_png(const ShowOptions& options, const Session& session) {
  const auto& input = options.inputs.front();
  refuse_input_file(*options.png, input);
  viewer::ShownImage image = prepare(input, options, session);
  if (options.bus_rate > 0) report_transfer(image, options);
  eltek::TraceRecorder recorder;
  const viewer::ScreenView view({std::move(image)}, options.crop, &recorder);
  require_picture_name(*options.png);
  viewer::write_indexed_png(*options.png, view.capture());
  save_trace(options, recorder, session);
  return kDone;
}

#ifdef SIR_WITH_SDL
int open_window(const ShowOptions& options, const Session& session) {
  std::vector<viewer::ShownImage> images;
  for (const auto& input : options.inputs) images.push_back(prepare(input, options, session));
  if (options.bus_rate > 0)
    for (const viewer::ShownImage& image : images) report_transfer(image, options);
  flush_output();  // before the window, not when it is closed
  eltek::TraceRecorder recorder;
  viewer::WindowOptions window;
  if (options.trace) window.bus_listener = &recorder;
  window.image_area_only = options.crop;
  window.report = [&session](const std::string& text) { note(session, text); };
  viewer::Window(std::move(images), std::move(window)).run(interruption());
  save_trace(options, recorder, session);
  return interrupted() ? kInterrupted : kDone;
}
#else
int open_window(const ShowOptions&, const Session&) {
  throw FileError("window", 0, "this build has none (it was made without SDL2); use --png OUT.png");
}
#endif

}  // namespace

int run_show(const ShowOptions& options, const Session& session) {
  check_trace(options);
  return options.png ? write_png(options, session) : open_window(options, session);
}

}  // namespace sir::cli
