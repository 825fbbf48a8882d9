#include "cli/cost/cost_options.h"

#include <memory>
#include <string>
#include <vector>

#include "cli/cost/answer.h"
#include "cli/cost_command.h"
#include "cli/option_values.h"
#include "cli/output_path.h"

namespace sir::cli {
namespace {

void add_only(CLI::App* sub, CostOptions& options) {
  sub->add_option_function<std::string>(
         "--only",
         [&options](const std::string& text) {
           if (!parse_knobs(text, options.only))
             throw CLI::ValidationError(
                 "--only",
                 fmt::format("\"{}\" is not a list with commas out of {}", text, known_knobs()));
         },
         "price these knobs alone, a list with commas out of " + known_knobs())
      ->type_name("KNOB,...");
}

// Rows of these options are of the LUT's part.
std::vector<CLI::Option*> add_own(CLI::App* sub, quant::ChooseOptions& own) {
  quant::HsvGridShape& grid = own.grid;
  return {
      add_number(sub, "--grey-s", grid.grey_s, 0, 1, "a row of your own: median in hsv with this"),
      add_number(sub, "--grey-v", grid.grey_v, 0, 1, "likewise; see sir lut --help"),
      add_parsed(sub, "--grid", grid, quant::parse_grid,
                 {"HxSxV", "HxSxV: 1 to 1024 hues, 2 to 1024 levels of S and V, 2^24 cells"},
                 "likewise"),
      sub->add_option("--sample", own.sample, "likewise")
          ->check(CLI::Range(1, 1'000'000'000))
          ->type_name("N")};
}

}  // namespace

void add_cost(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand(
      "cost", "What accuracy costs in time: the tracer's settings and the LUT's");
  const auto options = std::make_shared<CostOptions>();
  sub->add_option("IMAGE", options->inputs,
                  "BASE (a scene, or planes: then the LUT alone) or FILE.png; one or more")
      ->required();
  add_parsed(sub, "--budget", options->question.budget_ms, parse_time,
             {"TIME", "a time above 0 in s or ms, such as 2s or 500ms"},
             "say which is the most accurate within this time; exit 3 where nothing is");
  add_parsed(sub, "--target", options->question.target_db, parse_decibels,
             {"DB", "a PSNR above 0, such as 45dB"},
             "say which is the cheapest that reaches this PSNR; exit 3 where nothing does");
  add_only(sub, *options);
  sub->add_option("--repeats", options->repeats, "timed runs of each row (5)")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  sub->add_option("--threads", options->threads, "threads of the tracer (as many as cores)")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
  sub->add_option("--truth-samples", options->truth_samples,
                  "random rays a pixel of the picture that errors are measured against (64)")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
  const auto own = add_own(sub, options->own);
  add_size(sub, options->size, "size of what is rendered, or of the planes (640x480)");
  sub->add_flag("--json", options->json, "print JSON");
  sub->add_option("--csv", options->csv, "also write the rows as CSV")->type_name("FILE");
  sub->add_option("--html", options->html, "also write a page, with plots where there is gnuplot")
      ->type_name("FILE");
  sub->callback([&action, options, own] {
    for (const CLI::Option* option : own) options->has_own |= option->count() > 0;
    for (auto& input : options->inputs) input = given_base(input);
    if (options->csv && options->html && same_place(*options->csv, *options->html))
      throw CLI::ValidationError("--csv", "names the same file as --html");
    action = [options](const Session& session) { return run_cost(*options, session); };
  });
}

}  // namespace sir::cli
