#include "cli/why_options.h"

#include <memory>
#include <string>

#include "cli/option_values.h"
#include "cli/why_command.h"
#include "quant/choose.h"

namespace sir::cli {
namespace {

enum class Choice { frequency, median, best };

viewer::Method method_of(Choice choice, quant::Space space) {
  const bool rgb = space == quant::Space::rgb;
  switch (choice) {
    case Choice::frequency:
      return rgb ? viewer::Method::rgb_frequency : viewer::Method::hsv_frequency;
    case Choice::median: return rgb ? viewer::Method::rgb_median : viewer::Method::hsv_median;
    case Choice::best: break;
  }
  return viewer::Method::best;
}

}  // namespace

void add_why(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand(
      "why", "Why a pixel looks as it does: its ray, its cell and boxes, its entry and code");
  const auto options = std::make_shared<WhyOptions>();
  const auto choice = std::make_shared<Choice>(Choice::median);
  const auto space = std::make_shared<quant::Space>(quant::Space::hsv);
  sub->add_option("IMAGE", options->input, "BASE (planes) or FILE.png")->required();
  sub->add_option("COLUMN", options->column, "column of the pixel, from 0 at the left")->required();
  sub->add_option("ROW", options->row, "row of the pixel, from 0 at the top")->required();
  auto* method = add_choice(
      sub, "--method", *choice,
      {{"frequency", Choice::frequency}, {"median", Choice::median}, {"best", Choice::best}},
      "choose the LUT by this method (median)");
  auto* in =
      add_choice(sub, "--space", *space, {{"rgb", quant::Space::rgb}, {"hsv", quant::Space::hsv}},
                 "frequency and median: grid that colours are counted in (hsv)");
  sub->add_option("--lut", options->lut, "the LUT (BASE.LUT, else one that is chosen)")
      ->type_name("FILE.LUT")
      ->excludes(method)
      ->excludes(in);
  add_choice(sub, "--map", options->map.by,
             {{"rgb", quant::Goal::psnr}, {"perceptual", quant::Goal::perceptual}},
             "how colours are compared: by their bytes or by the eye (rgb)");
  add_choice(sub, "--dither", options->map.dither,
             {{"none", quant::Dither::none},
              {"floyd", quant::Dither::floyd},
              {"blue-noise", quant::Dither::blue_noise}},
             "entries side by side for the colours between them (none)");
  add_size(sub, options->size, "size of the planes (640x480)");
  sub->add_flag("--json", options->json, "print JSON");
  sub->callback([=, &action] {
    if (*choice == Choice::best && in->count() > 0)
      throw CLI::ValidationError("--space", "belongs to --method frequency and median");
    if (method->count() + in->count() > 0) options->method = method_of(*choice, *space);
    options->input = given_base(options->input);
    action = [options](const Session& session) { return run_why(*options, session); };
  });
}

}  // namespace sir::cli
