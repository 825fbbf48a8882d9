#include "cli/options.h"

#include <unistd.h>

#include <iostream>
#include <limits>
#include <memory>
#include <sstream>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/add_option.h"
#include "cli/colour_options.h"
#include "cli/command_line.h"
#include "cli/cost/cost_options.h"
#include "cli/effects_command.h"
#include "cli/export_command.h"
#include "cli/hsv_command.h"
#include "cli/lut_options.h"
#include "cli/metrics_command.h"
#include "cli/model_command.h"
#include "cli/option_values.h"
#include "cli/planes_command.h"
#include "cli/probe_command.h"
#include "cli/render_command.h"
#include "cli/replay_command.h"
#include "cli/scene_commands.h"
#include "cli/session.h"
#include "cli/show_options.h"
#include "cli/table_command.h"
#include "cli/tracing_options.h"
#include "cli/version_text.h"
#include "cli/why_options.h"
#include "tracer/error.h"
#include "tracer/limits.h"
#include "tracer/text_file.h"

namespace sir::cli {
namespace {

using Path = std::filesystem::path;

void add_render(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand("render", "Render BASE's scene to planes and PNG");
  const auto command = std::make_shared<RenderCommand>();
  sub->add_option("BASE", command->base, "BASE.CSG, BASE.CAM, BASE.LUZ, BASE.SUP")->required();
  sub->add_option("--out", command->out, "folder of the outputs (beside BASE)")->type_name("DIR");
  add_tracing(sub, command->options);
  add_threads(sub, command->options.threads);
  add_parsed(sub, "--region", command->options.region, parse_region,
             {"X,Y,W,H", "X,Y,W,H in pixels, W and H positive"},
             "render this rectangle of the image alone; the outputs hold nothing else");
  add_formulas(sub, command->options.trace.formulas);
  add_antialias(sub, command->options.antialias);
  sub->add_flag("--progressive", command->progressive,
                "coarse to fine: BASE.png is the picture so far, the planes wait for the end");
  sub->add_flag_callback(
      "--no-png", [command] { command->png = false; }, "write the planes only");
  sub->add_flag("--stats", command->stats, "print counts and times as JSON");
  sub->add_flag("--resume", command->resume,
                "continue an interrupted render from its finished tiles, to the same bytes");
  add_number(sub, "--keep-after", command->keep_after, 0, 1e9,
             "keep finished tiles in BASE.tiles after so many seconds of rendering (5)");
  sub->add_option("--hesitation", command->hesitation,
                  "also write the image with the pixels marked whose hits depend on float against "
                  "double (red) or on the rounding of t (blue; both: yellow), judged by the ray "
                  "through their centre, and print the nodes")
      ->type_name("OUT.png");
  sub->callback([&action, command] {
    const Region& r = command->options.region;
    const ImageSize size = command->options.size;
    if (command->hesitation && command->options.trace.formulas == Formulas::textbook)
      throw CLI::ValidationError("--hesitation", "is of the robust formulas only");
    if (r.x + std::int64_t{r.width} > size.width || r.y + std::int64_t{r.height} > size.height)
      throw CLI::ValidationError("--region",
                                 fmt::format("does not lie within {}x{}", size.width, size.height));
    if (command->progressive && !command->png)
      throw CLI::ValidationError("--progressive",
                                 "shows the picture so far in the PNG, which --no-png forbids");
    command->base = given_base(command->base);
    action = [command](const Session& session) { return run_render(*command, session); };
  });
}

void add_probe(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand(
      "probe", "Where rays cross BASE's solid: lines `ox oy oz dx dy dz` in, JSON lines out");
  const auto command = std::make_shared<ProbeCommand>();
  sub->add_option("BASE", command->base, "the scene")->required();
  add_precision(sub, command->precision);
  add_engine(sub, command->engine);
  sub->callback([&action, command] {
    command->base = given_base(command->base);
    action = [command](const Session& session) {
      return run_probe(*command, STDIN_FILENO, session);
    };
  });
}

void add_check(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand("check", "Say what is wrong with BASE's files, or what they hold");
  const auto base = std::make_shared<Path>();
  sub->add_option("BASE", *base, "the scene")->required();
  sub->callback([&action, base] {
    action = [base](const Session& session) { return run_check(given_base(*base), session); };
  });
}

void add_effects(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand(
      "effects", "The effects that BASE's scene calls for, and why; what each costs and changes");
  const auto command = std::make_shared<EffectsCommand>();
  sub->add_option("BASE", command->base, "the scene")->required();
  add_tracing(sub, command->options);
  add_antialias(sub, command->options.antialias);
  add_threads(sub, command->options.threads);
  sub->add_option("--repeats", command->repeats, "timed runs of each (5)")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  sub->add_flag("--json", command->json, "print JSON");
  sub->callback([&action, command] {
    command->base = given_base(command->base);
    action = [command](const Session& session) { return run_effects(*command, session); };
  });
}

void add_trace(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand("trace", "The tree of a pixel's rays and surfaces");
  const auto command = std::make_shared<TraceCommand>();
  sub->add_option("BASE", command->base, "the scene")->required();
  sub->add_option("I", command->i, "column of the pixel, from 0 at the left")->required();
  sub->add_option("J", command->j, "row of the pixel, from 0 at the top")->required();
  add_tracing(sub, command->options);
  sub->callback([&action, command] {
    const ImageSize size = command->options.size;
    if (command->i < 0 || command->i >= size.width || command->j < 0 || command->j >= size.height)
      throw CLI::ValidationError(
          "I J", fmt::format("the pixel does not lie within {}x{}", size.width, size.height));
    command->base = given_base(command->base);
    action = [command](const Session& session) { return run_trace(*command, session); };
  });
}

void add_metrics(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand("metrics", "How far SHOWN is from REF, in numbers");
  const auto options = std::make_shared<MetricsOptions>();
  sub->add_option("REF", options->reference, "BASE (planes) or FILE.png")->required();
  sub->add_option("SHOWN", options->shown, "the image as shown, of the same size")->required();
  std::string names;
  for (const std::string& name : metric_names()) names += (names.empty() ? "" : " ") + name;
  const auto add_threshold = [&](const std::string& option, Threshold::Fails fails,
                                 const std::string& help) {
    sub->add_option_function<std::vector<std::string>>(
           option,
           [options, fails, option, names](const std::vector<std::string>& texts) {
             for (const std::string& text : texts) {
               Threshold threshold{{}, 0, fails};
               if (!parse_threshold(text, threshold))
                 throw CLI::ValidationError(
                     option,
                     fmt::format("\"{}\" is not NAME=X with a number X and a NAME out of {}", text,
                                 names));
               options->thresholds.push_back(threshold);
             }
           },
           help)
        ->allow_extra_args(false)
        ->type_name("NAME=X");
  };
  add_threshold("--fail-above", Threshold::Fails::above,
                "exit 3 where the metric is greater; may be repeated; NAME: " + names);
  add_threshold("--fail-below", Threshold::Fails::below, "exit 3 where it is less");
  sub->add_option("--heat-map", options->heat_map,
                  "write CIEDE2000 as an image: black 0, blue 2.5, red 5, yellow 7.5, white >= 10")
      ->type_name("FILE.png");
  sub->add_option("--lut", options->lut,
                  "also say what REF loses through this LUT by its entries, by the DAC's bits "
                  "and by the mapping")
      ->type_name("FILE.LUT");
  add_size(sub, options->size, "size of the planes (640x480)");
  sub->add_flag("--json", options->json, "print JSON");
  sub->callback([&action, options] {
    options->reference = given_base(options->reference);
    options->shown = given_base(options->shown);
    action = [options](const Session& session) { return run_metrics(*options, session); };
  });
}

void add_planes(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand("planes", "Planes to PNG (BASE), or back (FILE.png)");
  const auto options = std::make_shared<PlanesOptions>();
  sub->add_option("IMAGE", options->input, "BASE (planes) or FILE.png")->required();
  auto* file = sub->add_option("-o", options->output, "the PNG's file, or the planes' base name");
  file->type_name("FILE");
  sub->add_option("--out", options->folder, "folder of the outputs")
      ->type_name("DIR")
      ->excludes(file);
  add_size(sub, options->size, "size of the planes (640x480)");
  sub->callback([&action, options] {
    options->input = given_base(options->input);
    action = [options](const Session& session) { return run_planes(*options, session); };
  });
}

void add_table(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand("table", "Table 4.1 on the five images, the thesis's beside it");
  const auto command = std::make_shared<TableCommand>();
  sub->add_option("--images", command->images, "folder of the five scenes")->type_name("DIR");
  sub->add_option("--planes", command->planes, "folder of their planes, to save rendering them")
      ->type_name("DIR");
  sub->add_option("--repeats", command->repeats, "timed runs (5)")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  sub->add_flag("--json", command->json, "print JSON");
  sub->add_option("--html", command->html, "also write a report: one page with all pictures in it")
      ->type_name("FILE");
  sub->callback([&action, command] {
    action = [command](const Session& session) { return run_table(*command, session); };
  });
}

void add_export(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand("export", "BASE's scene in the language of another program");
  const auto command = std::make_shared<ExportCommand>();
  sub->add_option("BASE", command->base, "BASE.CSG, BASE.CAM, BASE.LUZ, BASE.SUP")->required();
  sub->add_option("--pov", command->pov,
                  "write the scene for POV-Ray 3.7; its head says how to "
                  "render it and what differs")
      ->required()
      ->type_name("FILE");
  add_choice(sub, "--scale", command->options.scale,
             {{"fit", PovScale::fit}, {"keep", PovScale::keep}},
             "move and scale the scene to suit POV-Ray's tolerances, or keep its numbers (fit)");
  sub->add_option("--depth", command->options.depth_limit, "depth limit of the tree of rays (5)")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N");
  add_size(sub, command->options.size, "image size, for the command line in the head (640x480)");
  sub->callback([&action, command] {
    command->base = given_base(command->base);
    action = [command](const Session& session) { return run_export(*command, session); };
  });
}

void add_hsv(CLI::App& app, Action& action) {
  auto* sub =
      app.add_subcommand("hsv", "Bytes `r g b` in, one a line; their place in the HSV grid out");
  sub->callback([&action] {
    action = [](const Session& session) { return run_hsv(STDIN_FILENO, session); };
  });
}

// They hold for every command, before the command as after it, and are in force before its own
// options are read.
void add_limits(CLI::App& app) {
  const auto add = [&app](const std::string& name, std::size_t Limits::*limit, std::size_t most,
                          const std::string& help) {
    app.add_option_function<std::size_t>(
           name,
           [limit](const std::size_t& value) {
             Limits changed = limits();
             changed.*limit = value;
             set_limits(changed);
           },
           help)
        ->check(CLI::Range(std::size_t{1}, most))
        ->type_name("N");
  };
  const Limits usual;
  add("--max-nodes", &Limits::nodes, kMostNodes,
      fmt::format("most nodes, and surfaces, and lights, of a scene that is read ({})",
                  usual.nodes));
  add("--max-pixels", &Limits::pixels, kMostPixels,
      fmt::format("most pixels of an image ({})", usual.pixels));
}

}  // namespace

std::vector<const CLI::App*> subcommands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

void add_all(CLI::App& app, Session& session, Action& action) {
  app.description("SIR: CSG scenes, 256-entry lookup tables and the Eltek MA120 of 1989.");
  app.set_version_flag("--version", version_text);
  app.add_flag("-q", session.quiet, "say nothing but errors");
  app.add_flag("-v", session.verbose, "say more");
  add_limits(app);
  app.require_subcommand(1);
  add_model(app, action);
  add_render(app, action);
  add_lut(app, action);
  add_paint(app, action);
  add_cost(app, action);
  add_show(app, action);
  add_replay(app, action);
  add_metrics(app, action);
  add_table(app, action);
  add_check(app, action);
  add_effects(app, action);
  add_trace(app, action);
  add_why(app, action);
  add_probe(app, action);
  add_hsv(app, action);
  add_planes(app, action);
  add_export(app, action);
  for (CLI::App* sub : app.get_subcommands([](CLI::App*) { return true; })) sub->fallthrough();
}

int run(int argc, char** argv) {
  CLI::App app("", "sir");
  Session session;
  Action action;
  add_all(app, session, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool is_answer = error.get_exit_code() == 0;  // --help, --version
    // CLI11 would only say that a subcommand is required.
    if (!is_answer && app.get_subcommands().empty() && !app.remaining().empty()) {
      std::cerr << "sir: there is no command or option " << app.remaining().front()
                << "\nRun with --help for more information.\n";
      return kUsage;
    }
    // Not to std::cout: CLI11 flushes it, and a full disk would go unnoticed.
    std::ostringstream out, wrong;
    app.exit(error, out, wrong);
    print(out.str());
    if (!is_answer) std::cerr << "sir: " << wrong.str();
    return is_answer ? kDone : kUsage;
  }
  return action(session);
}

}  // namespace sir::cli
