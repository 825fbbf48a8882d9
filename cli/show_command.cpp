#include "cli/show_command.h"

#include <string>
#include <utility>
#include <vector>

#include "cli/image_input.h"
#include "cli/interrupt.h"
#include "cli/monitor_options.h"
#include "cli/output_path.h"
#include "eltek/display_driver.h"
#include "quant/choose.h"
#include "quant/dac_parse.h"
#include "quant/map_image.h"
#include "tracer/atomic_file.h"
#include "tracer/error.h"
#include "tracer/scene_path.h"
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
    if (options.png) refuse_same_file(*options.png, *path);
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

void write_png(const std::filesystem::path& path, const eltek::IndexedScreen& screen,
               const std::optional<eltek::Crt>& crt) {
  require_picture_name(path);
  if (crt) viewer::write_rgb_png(path, to_planes(crt->show(screen)));
  else viewer::write_indexed_png(path, screen);
}

// To a file, to standard output, or both.
int show_without_window(const ShowOptions& options, const Session& session) {
  const TerminalForm form = settle(options.terminal.value_or(TerminalForm::sixel));
  if (interrupted()) return kInterrupted;
  std::optional<eltek::Crt> crt;
  if (options.crt) note(session, monitor_text(crt.emplace(*options.crt)));
  for (const auto& input : options.inputs) {
    if (options.png) refuse_input_file(*options.png, input);
    const viewer::ScreenView view({prepare(input, options, session)}, options.crop);
    if (options.png) write_png(*options.png, view.capture(), crt);
    if (options.terminal) print_screen(view.capture(), crt, form);
  }
  return kDone;
}

#ifdef SIR_WITH_SDL
int open_window(const ShowOptions& options, const Session& session) {
  std::vector<viewer::ShownImage> images;
  for (const auto& input : options.inputs) images.push_back(prepare(input, options, session));
  viewer::WindowOptions window;
  window.image_area_only = options.crop;
  window.report = [&session](const std::string& text) { note(session, text); };
  viewer::Window(std::move(images), std::move(window)).run(interruption());
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
  return options.png || options.terminal ? show_without_window(options, session)
                                         : open_window(options, session);
}

}  // namespace sir::cli
