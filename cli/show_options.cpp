#include "cli/show_options.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "cli/monitor_options.h"
#include "cli/option_values.h"
#include "cli/show_command.h"

namespace sir::cli {
namespace {

// A value only after "=": what follows --terminal is an image. Returns what tells the form when the
// command line has been read.
std::function<std::optional<TerminalForm>()> add_terminal(CLI::App* app) {
  static const std::map<std::string, TerminalForm> kForms{{"auto", TerminalForm::automatic},
                                                          {"blocks", TerminalForm::blocks},
                                                          {"sixel", TerminalForm::sixel}};
  const auto name = std::make_shared<std::string>();
  app->add_flag("--terminal{auto}", *name,
                "show the screen in the terminal: =sixel graphics, =blocks of 24-bit colours, or "
                "=auto, what it can (auto)")
      ->check(CLI::IsMember(kForms));
  return [name] { return name->empty() ? std::nullopt : std::optional(kForms.at(*name)); };
}

}  // namespace

void add_show(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand("show", "Show images on the MA120's screen");
  const auto options = std::make_shared<ShowOptions>();
  sub->add_option("IMAGE", options->inputs,
                  "BASE (planes; in a window also a scene, rendered as you look) or FILE.png; "
                  "several in a window, where ? shows the keys")
      ->required();
  sub->add_option("--lut", options->lut, "the LUT (BASE.LUT, else median in hsv)")
      ->type_name("FILE.LUT");
  sub->add_option("--png", options->png,
                  "write the screen as a PNG, indexed, or RGB with --monitor crt; open no window")
      ->type_name("OUT.png");
  sub->add_option("--trace", options->trace,
                  "write what was done at the MA120's registers, for sir replay")
      ->type_name("FILE");
  add_parsed(
      sub, "--bus", options->bus_rate, parse_rate,
      {"RATE", "a rate in bytes a second, such as 500k or 1.2M"},
      "print the bytes that showing each image puts on a bus of so many bytes a second, such "
      "as 500k or 1.2M, and how long that takes");
  sub->add_flag("--crop", options->crop, "the image's area alone; also admits larger images");
  add_parsed(sub, "--reserve", options->map.reserved, quant::parse_indices,
             {"LIST", "a list of LUT entries from 0 to 255, such as 0-15,255"},
             "entries that no pixel takes, nor the screen around the image; such as 0-15,255");
  add_size(sub, options->size, "size of the planes (640x480)");
  add_choice(sub, "--dither", options->map.dither,
             {{"none", quant::Dither::none},
              {"floyd", quant::Dither::floyd},
              {"blue-noise", quant::Dither::blue_noise}},
             "entries side by side for the colours between them: by error diffusion, or by place, "
             "for animations (none)");
  add_choice(sub, "--map", options->map.by,
             {{"rgb", quant::Goal::psnr}, {"perceptual", quant::Goal::perceptual}},
             "how colours are compared: by their bytes, or by the eye, for LUTs chosen so (rgb)");
  const auto terminal = add_terminal(sub);
  const auto monitor = add_monitor(sub);
  sub->callback([&action, options, monitor, terminal] {
    options->terminal = terminal();
    options->crt = monitor();
    if (options->png && options->inputs.size() > 1)
      throw CLI::ValidationError("--png", "takes one image");
    if (options->map.reserved.all())
      throw CLI::ValidationError("--reserve", "leaves no entry to the image");
    for (std::filesystem::path& input : options->inputs) input = given_base(input);
    action = [options](const Session& session) { return run_show(*options, session); };
  });
}

}  // namespace sir::cli
