#include "cli/model_command.h"

#include <unistd.h>

#include <memory>
#include <string>

#include "cli/interrupt.h"
#include "cli/line_input.h"
#include "cli/model_prompt.h"
#include "cli/option_values.h"
#include "eltek/screen.h"
#include "modeler/csg.h"
#include "modeler/script.h"
#include "modeler/script_text.h"
#include "modeler/state_folder.h"
#include "tracer/error.h"
#include "tracer/scene_file.h"
#include "tracer/scene_path.h"
#include "viewer/half_blocks.h"
#ifdef SIR_WITH_IMGUI
#include "viewer/model_window.h"
#endif
#include "viewer/png_file.h"
#include "viewer/terminal.h"

namespace sir::cli {
namespace {

using Path = std::filesystem::path;

struct Quit {};  // thrown to leave for_each_line()

// A line by itself in UTF-8, whatever it came in.
std::string in_utf8(std::string_view line) {
  TextFile text("-", std::string(line));
  return text.next() ? std::string(text.line()) : std::string();
}

std::string draw(const Planes& picture, int columns) {
  eltek::Screen screen{picture.size, {}};
  for (std::size_t pixel = 0; pixel < picture.size.pixels(); ++pixel)
    screen.pixels.push_back(picture.at(pixel));
  return viewer::half_blocks(screen, columns);
}

void hear(const modeler::Reply& reply, const Session& session) {
  print(reply.text);
  for (const std::string& warning : reply.warnings) note(session, warning);
  if (!reply.done.empty()) detail(session, reply.done);
}

int run_standard_input(modeler::Interpreter& interpreter, const Session& session) {
  // What comes from a file is an input as a script is.
  const Path input = "/dev/stdin";
  std::error_code ignored;
  if (std::filesystem::is_regular_file(input, ignored)) interpreter.protect(input);
  modeler::Script script(interpreter, "-",
                         [&](const modeler::Reply& reply) { hear(reply, session); });
  std::size_t number = 0;
  const auto answer = [&](std::string_view line, bool too_long) {
    ++number;
    if (too_long)
      throw FileError("-", number,
                      "the line is longer than " + std::to_string(kLongestLine) + " bytes");
    if (!script.line(in_utf8(line), number)) throw Quit();
  };
  try {
    if (!for_each_line(STDIN_FILENO, answer, flush_output)) return kInterrupted;
  } catch (const Quit&) {
  }
  return interrupted() ? kInterrupted : kDone;
}

int run_file(const Path& path, modeler::Interpreter& interpreter, const Session& session) {
  interpreter.protect(path);
  TextFile file(path);
  run_script(file, interpreter, [&](const modeler::Reply& reply) { hear(reply, session); });
  return interrupted() ? kInterrupted : kDone;
}

int print_script(const Path& base) {
  TextFile file(find_by_suffix(base, "CSG"));
  const modeler::NodePtr solid = modeler::from_csg(read_csg(file));
  print(modeler::script_text(*solid, with_suffix(base.filename(), "CSG").string()));
  return kDone;
}

#ifdef SIR_WITH_IMGUI
void recover(viewer::ModelDesk& desk, const std::string& which) {
  if (!desk.execute(recover_line(which))) throw FileError("--recover", 0, desk.message());
}

int run_window(const ModelOptions& options, const Session& session) {
  if (options.script == "-") throw FileError("-", 0, "--window takes its script from a file");
  viewer::DeskOptions desk;
  desk.outlet = make_outlet();
  desk.journals = modeler::state_folder();
  desk.from = options.script ? options.script->string() : options.from.value_or("").string();
  viewer::ModelWindow window(std::move(desk), [&](viewer::ModelDesk& at) {
    if (options.script) at.run_script(*options.script);
    if (options.from) at.open(*options.from);
    if (options.recover) recover(at, *options.recover);
  });
  window.run(interruption());
  if (interrupted()) return kInterrupted;
  if (const std::string kept = window.desk().end(); !kept.empty()) note(session, kept);
  return kDone;
}
#else
int run_window(const ModelOptions&, const Session&) {
  throw FileError("window", 0,
                  "this build has none (it needs SDL2 and Dear ImGui); leave out --window");
}
#endif

}  // namespace

modeler::Outlet make_outlet() {
  modeler::Outlet outlet;
  outlet.write_picture = [](const Path& file, const Planes& picture) {
    viewer::write_rgb_png(file, picture);
  };
  outlet.draw = draw;
  outlet.columns = [] { return viewer::terminal_columns(STDOUT_FILENO).value_or(80); };
  outlet.stop = interruption();
  return outlet;
}

int run_model(const ModelOptions& options, const Session& session) {
  if (options.window) return run_window(options, session);
  if (options.from) return print_script(*options.from);
  if (options.recover && ::isatty(STDIN_FILENO) != 1)
    throw FileError("--recover", 0, "a session goes on at a terminal, or with --window");
  modeler::Interpreter interpreter(make_outlet());
  if (options.script && *options.script != "-")
    return run_file(*options.script, interpreter, session);
  if (!options.script && ::isatty(STDIN_FILENO) == 1)
    return run_prompt(interpreter, session, options.recover);
  return run_standard_input(interpreter, session);
}

void add_model(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand(
      "model", "Model solids: by commands at a prompt, from standard input or from a script");
  const auto options = std::make_shared<ModelOptions>();
  auto* script = sub->add_option("SCRIPT", options->script, "commands, one a line (-: from stdin)");
  auto* from = sub->add_option("--from", options->from, "print the script that makes BASE.CSG")
                   ->type_name("BASE")
                   ->excludes(script);
  sub->add_flag("--window", options->window,
                "work in a window; with --from on BASE.CSG, seen by BASE.CAM, .LUZ and .SUP");
  sub->add_option("--recover", options->recover,
                  "begin with a session that was not ended: the last, or SESSION")
      ->type_name("SESSION")
      ->expected(0, 1)
      ->excludes(script)
      ->excludes(from);
  sub->footer("The commands: sir model, then help; docs/modeler.md.");
  sub->callback([&action, options] {
    if (options->from) options->from = given_base(*options->from);
    action = [options](const Session& session) { return run_model(*options, session); };
  });
}

}  // namespace sir::cli
