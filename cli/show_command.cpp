#include "cli/show_command.h"

#include <string>
#include <utility>
#include <vector>

#include "cli/image_input.h"
#include "cli/interrupt.h"
#include "cli/output_path.h"
#include "eltek/display_driver.h"
#include "quant/dac_parse.h"
#include "tracer/atomic_file.h"
#include "tracer/error.h"
#include "tracer/scene_path.h"
#include "viewer/png_file.h"
#include "viewer/rendition.h"
#include "viewer/screen_view.h"
#ifdef SIR_WITH_SDL
#include "viewer/window.h"
#endif

namespace sir::cli {
namespace {

viewer::ShownImage prepare(const std::filesystem::path& input, const ShowOptions& options,
                           const Session& session) {
  viewer::Picture picture;
  picture.input = input;
  picture.base = base_name(input);
  picture.planes = load_image(input, options.size);
  // An image that does not fit is refused before a LUT is sought for it.
  eltek::place(input.string(), picture.planes.size,
               options.crop ? eltek::Oversize::crop : eltek::Oversize::refuse);
  const viewer::RenditionOptions rendition{options.map, options.lut};
  const auto path = viewer::lut_file(picture.base, rendition);
  if (path && options.png) refuse_same_file(*options.png, *path);
  auto made = viewer::make_rendition(
      picture, path ? viewer::Method::lut_file : viewer::Method::hsv_median, rendition);
  if (path) detail(session, input.string() + ": shown with " + path->string());
  else
    note(session, input.string() + ": there is no " + with_suffix(picture.base, "LUT").string() +
                      "; shown with a LUT " + made.lut_name);
  if (made.lut.dac != quant::DacBits{})
    note(session, input.string() + ": shown through a DAC of " + quant::bits_text(made.lut.dac) +
                      " bits, which the MA120 did not have");
  return {picture.base,
          std::move(made.lut_name),
          picture.planes.size,
          std::move(made.indices),
          made.lut,
          made.reserved};
}

int write_png(const ShowOptions& options, const Session& session) {
  const auto& input = options.inputs.front();
  refuse_input_file(*options.png, input);
  const viewer::ScreenView view({prepare(input, options, session)}, options.crop);
  require_picture_name(*options.png);
  viewer::write_indexed_png(*options.png, view.capture());
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
  throw FileError("window", 0, "this build has none (it was made without SDL2); use --png OUT.png");
}
#endif

}  // namespace

int run_show(const ShowOptions& options, const Session& session) {
  return options.png ? write_png(options, session) : open_window(options, session);
}

}  // namespace sir::cli
