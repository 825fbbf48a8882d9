#include "cli/colour_options.h"

#include <memory>
#include <string>

#include "cli/option_values.h"
#include "cli/paint_command.h"

namespace sir::cli {
void add_paint(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand(
      "paint", "Show the colours within ranges of hue, saturation and value as another colour");
  const auto options = std::make_shared<PaintOptions>();
  sub->add_option("IMAGE", options->input, "BASE (planes) or FILE.png")->required();
  sub->add_option("-o", options->output, "the painted image")->required()->type_name("OUT.png");
  quant::PaintRule& own = options->own;
  add_parsed(sub, "--hue", own.hue, quant::parse_hue_range,
             {"LOW..HIGH", "a range of degrees from 0 to 360, such as 350..20 or 90.5"},
             "degrees, ends included; 350..20 passes through red; greys have no hue");
  const Form unit{"LOW..HIGH", "a range from 0 to 1, such as 0.3..0.6, 0.3.. or ..0.6"};
  add_parsed(sub, "--saturation", own.saturation, quant::parse_unit_range, unit,
             "0 to 1, ends included; 0.3.. and ..0.6 are open");
  add_parsed(sub, "--value", own.value, quant::parse_unit_range, unit, "likewise");
  auto* with =
      add_parsed(sub, "--with", own.with, quant::parse_brush,
                 {"R,G,B|hue:DEGREES|keep", "bytes R,G,B, hue: and degrees from 0 to 360, or keep"},
                 "the colour to show; another hue alone; or the pixel as it is");
  sub->add_option_function<std::vector<std::string>>(
         "--rule",
         [options](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) {
             options->rules.emplace_back();
             if (!quant::parse_rule(text, options->rules.back()))
               throw CLI::ValidationError(
                   "--rule", fmt::format("\"{}\" is not a rule such as \"h=350..20 s=0.3.. v=..0.5 "
                                         "with=255,0,0\"",
                                         text));
           }
         },
         "the same in one text, \"h=350..20 s=0.3.. v=..0.5 with=255,0,0\"; repeated, the first "
         "rule that picks a pixel paints it")
      ->type_name("RULE")
      ->allow_extra_args(false);
  add_choice(sub, "--rest", options->rest,
             {{"keep", quant::Rest::keep}, {"grey", quant::Rest::grey}},
             "pixels that no rule picks (keep)");
  add_size(sub, options->size, "size of the planes (640x480)");
  sub->add_flag("--json", options->json, "print JSON");
  sub->callback([&action, options, with] {
    const quant::PaintRule& rule = options->own;
    const bool has_range = rule.hue || rule.saturation || rule.value;
    if (has_range != (with->count() > 0) || (!has_range && options->rules.empty()))
      throw CLI::ValidationError(
          "--with", "goes with one or more of --hue, --saturation and --value; or give a --rule");
    if (has_range) options->rules.insert(options->rules.begin(), rule);
    options->input = given_base(options->input);
    action = [options](const Session& session) { return run_paint(*options, session); };
  });
}

}  // namespace sir::cli
