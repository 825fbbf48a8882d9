#include "cli/show_command.h"

#include <string>
#include <utility>

#include "cli/image_input.h"
#include "cli/interrupt.h"
#include "cli/monitor_options.h"
#include "cli/output_path.h"
#include "cli/show_trace.h"
#include "cli/shown_image.h"
#include "quant/lut.h"
#include "tracer/atomic_files.h"
#include "tracer/error.h"
#include "viewer/image_name.h"
#include "viewer/png_file.h"
#include "viewer/source.h"
#include "viewer/station.h"
#ifdef SIR_WITH_SDL
#include "viewer/window.h"
#endif

namespace sir::cli {
namespace {

void write_png(AtomicFiles& files, const std::filesystem::path& path,
               const eltek::IndexedScreen& screen, const std::optional<eltek::Crt>& crt) {
  require_picture_name(path);
  AtomicFile& file = files.add(path);
  if (crt) viewer::write_rgb_png(file, to_planes(crt->show(screen)));
  else viewer::write_indexed_png(file, screen);
}

// To a file, to standard output, or both.
int show_without_window(const ShowOptions& options, const Session& session) {
  const TerminalForm form = settle(options.terminal.value_or(TerminalForm::sixel));
  if (interrupted()) return kInterrupted;
  if (options.png) require_writable(*options.png);
  std::optional<eltek::Crt> crt;
  if (options.crt) note(session, monitor_text(crt.emplace(*options.crt)));
  eltek::TraceRecorder recorder;
  viewer::Station station(options.crop);
  station.add_listener(recorder);
  AtomicFiles together;
  for (const auto& input : options.inputs) {
    if (options.png) refuse_input_file(*options.png, input);
    const ShownImage image = prepare(input, options, session);
    station.show(input.string(), image.picture.planes.size, image.rendition);
    report_transfer(image, options);
    if (options.png) write_png(together, *options.png, station.capture(), crt);
    if (options.terminal) print_screen(station.capture(), crt, form);
  }
  save_trace(together, options, recorder, session);
  return kDone;
}

#ifdef SIR_WITH_SDL
// What is not there at all is said before a window opens; what cannot be read, in the window.
void require_inputs(const ShowOptions& options) {
  if (options.lut) {
    viewer::refuse_special_file(*options.lut);
    quant::read_lut(*options.lut);
  }
  for (const auto& input : options.inputs) {
    bool any = false;
    for (const auto& file : viewer::Source(input).files()) any |= std::filesystem::exists(file);
    if (!any) viewer::read_source(viewer::Source(input), options.size);  // says where it looked
  }
}

int open_window(const ShowOptions& options, const Session& session) {
  require_inputs(options);
  if (options.bus_rate > 0)
    for (const auto& input : options.inputs)
      report_transfer(prepare(input, options, session), options);
  if (options.crt) note(session, monitor_text(eltek::Crt(*options.crt)));
  flush_output();  // before the window, not when it is closed
  eltek::TraceRecorder recorder;
  viewer::ViewerOptions viewer;
  viewer.workshop.size = options.size;
  viewer.workshop.rendition = {options.map, options.lut};
  viewer.image_area_only = options.crop;
  viewer.crt = options.crt;
  if (options.trace) viewer.listener = &recorder;
  viewer.report = [&session](const std::string& text) { note(session, text); };
  viewer::Window(options.inputs, std::move(viewer)).run(interruption());
  AtomicFiles together;
  save_trace(together, options, recorder, session);
  return interrupted() ? kInterrupted : kDone;
}
#else
int open_window(const ShowOptions&, const Session&) {
  throw FileError(
      "window", 0,
      "this build has none (it was made without SDL2); use --terminal or --png OUT.png");
}
#endif

}  // namespace

int run_show(const ShowOptions& options, const Session& session) {
  check_trace(options);
  return options.png || options.terminal ? show_without_window(options, session)
                                         : open_window(options, session);
}

}  // namespace sir::cli
