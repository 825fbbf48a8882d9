#include "cli/lut_options.h"

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/lut_command.h"
#include "cli/option_values.h"
#include "quant/best_places.h"
#include "quant/dac_parse.h"

namespace sir::cli {
namespace {

enum class Method { frequency, median, best };

using Options = std::vector<CLI::Option*>;

// Options of the thesis's methods.
Options add_choice_options(CLI::App* sub, quant::ChooseOptions& choice) {
  return {add_choice(sub, "--space", choice.space,
                     {{"rgb", quant::Space::rgb}, {"hsv", quant::Space::hsv}},
                     "grid that colours are counted in (hsv)"),
          add_choice(sub, "--split", choice.split,
                     {{"pixels", quant::SplitOrder::pixels},
                      {"breadth", quant::SplitOrder::breadth},
                      {"longest", quant::SplitOrder::longest}},
                     "median: which box is split next (pixels)"),
          add_number(sub, "--grey-s", choice.grid.grey_s, 0, 1,
                     "hsv: saturations up to this are grey (0.2)"),
          add_number(sub, "--grey-v", choice.grid.grey_v, 0, 1,
                     "hsv: values up to this are grey (0.2)"),
          add_parsed(sub, "--grid", choice.grid, quant::parse_grid,
                     {"HxSxV", "HxSxV: 1 to 1024 hues, 2 to 1024 levels of S and V, 2^24 cells"},
                     "hsv: the grid (36x30x30)"),
          sub->add_option("--rgb-bits", choice.rgb_bits, "rgb: the grid's bits a primary (5)")
              ->check(CLI::Range(1, quant::RgbGrid::kMaxBits))
              ->type_name("N"),
          sub->add_option("--sample", choice.sample, "count every Nth pixel only (1)")
              ->check(CLI::Range(1, 1'000'000'000))
              ->type_name("N")};
}

CLI::Option* add_pins(CLI::App* sub, std::vector<quant::Pin>& pins) {
  return sub
      ->add_option_function<std::vector<std::string>>(
          "--pin",
          [&pins](const std::vector<std::string>& texts) {
            for (const std::string& text : texts)
              if (!quant::parse_pin(text, pins.emplace_back()))
                throw CLI::ValidationError(
                    "--pin", fmt::format("\"{}\" is not codes R,G,B or INDEX=R,G,B", text));
          },
          "best: an entry that is given, at an index or the lowest free one; may be repeated")
      ->type_name("[INDEX=]R,G,B")
      ->allow_extra_args(false);
}

// Options of the method best.
Options add_best_options(CLI::App* sub, BestCommand& best, quant::DacBits& dac) {
  quant::BestOptions& options = best.options;
  return {
      add_choice(sub, "--goal", options.goal,
                 {{"perceptual", quant::Goal::perceptual}, {"psnr", quant::Goal::psnr}},
                 "best: little difference to the eye, or to the bytes (perceptual)"),
      sub->add_option("--effort", options.effort, "best: 1, in a hurry, to 5, to the last gain (3)")
          ->check(CLI::Range(quant::kMinEffort, quant::kMaxEffort))
          ->type_name("N"),
      sub->add_option("--entries", options.entries,
                      "best: at most so many entries (all that are not reserved)")
          ->check(CLI::Range(std::size_t{1}, quant::kLutEntries))
          ->type_name("N"),
      add_parsed(sub, "--bits", dac, quant::parse_bits,
                 {"R,G,B", "bits R,G,B of a DAC, 1 to 8 each"},
                 "best: for a DAC of these bits: 4,4,4 Amiga, 5,6,5, 8,8,8 (6,6,6)"),
      add_pins(sub, options.pins),
      add_parsed(sub, "--reserve", options.reserved, quant::parse_indices,
                 {"LIST", "indices or ranges from 0 to 255 such as 0-15,255"},
                 "best: indices that are left to others"),
      sub->add_flag("--protect-hues", options.protect_hues,
                    "best: every hue of the image keeps an entry"),
      sub->add_option("--from", best.from,
                      "best: start from this LUT and keep its order and its reserved entries")
          ->type_name("FILE.LUT"),
      sub->add_option("--mask", best.masks,
                      "best: how much each pixel counts: white fully, black not at all; for "
                      "several images, one for each")
          ->type_name("FILE.png")
          ->allow_extra_args(false)};
}

void refuse_any(const Options& options, const std::string& reason) {
  for (const CLI::Option* option : options)
    if (option->count() > 0) throw CLI::ValidationError(option->get_name(), reason);
}

// What is wrong with the options among themselves.
void check(const LutOptions& options) {
  if (options.inputs.size() > 1) {
    if (!options.best)
      throw CLI::ValidationError("IMAGE", "several images share a LUT by --method best only");
    if (!options.output)
      throw CLI::ValidationError("-o", "is needed to name the LUT that several images share");
  }
  if (!options.best) return;
  const auto& masks = options.best->masks;
  if (!masks.empty() && masks.size() != options.inputs.size())
    throw CLI::ValidationError("--mask", "is needed once for each image, in their order");
  quant::BestOptions best = options.best->options;
  if (best.reserved.all()) throw CLI::ValidationError("--reserve", "leaves no entry to the image");
  if (options.best->from) best.dac = {{8, 8, 8}};  // which it is, is known once it is read
  try {
    (void)quant::places_of(best);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--entries, --pin, --reserve", error.what());
  }
}

}  // namespace

void add_lut(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand("lut", "Choose the 256 colours of an image and write BASE.LUT");
  const auto options = std::make_shared<LutOptions>();
  const auto best = std::make_shared<BestCommand>();
  const auto method = std::make_shared<Method>(Method::median);
  const auto dac = std::make_shared<quant::DacBits>();
  sub->add_option("IMAGE", options->inputs,
                  "BASE (planes) or FILE.png; several share a LUT by --method best")
      ->required();
  add_choice(sub, "--method", *method,
             {{"frequency", Method::frequency}, {"median", Method::median}, {"best", Method::best}},
             "how colours are chosen (median)");
  const Options of_thesis = add_choice_options(sub, options->choice);
  const Options of_best = add_best_options(sub, *best, *dac);
  CLI::Option* bits = sub->get_option("--bits");
  CLI::Option* entries = sub->get_option("--entries");
  add_size(sub, options->size, "size of the planes (640x480)");
  sub->add_option("-o", options->output, "the LUT's file (BASE.LUT)")->type_name("FILE.LUT");
  sub->add_flag("--json", options->json, "print JSON");
  sub->callback([=, &action] {
    if (*method == Method::best) {
      refuse_any(of_thesis, "belongs to the methods frequency and median");
      best->options.dac = *dac;
      if (bits->count() > 0) best->dac = *dac;
      const std::size_t usable = quant::kLutEntries - best->options.reserved.count();
      if (entries->count() == 0 && usable > 0) best->options.entries = usable;
      options->best = *best;
    } else {
      refuse_any(of_best, "belongs to --method best");
      options->choice.method =
          *method == Method::median ? quant::Method::median : quant::Method::frequency;
    }
    for (auto& input : options->inputs) input = given_base(input);
    check(*options);
    action = [options](const Session& session) { return run_lut(*options, session); };
  });
}

}  // namespace sir::cli
