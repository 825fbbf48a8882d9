// Scripts of the modeler: the whole interpreter, with a folder in memory for its files.
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "fuzz/refusal.h"
#include "fuzz/scratch_files.h"
#include "fuzz/targets.h"
#include "modeler/command_error.h"
#include "modeler/command_line.h"
#include "modeler/csg.h"
#include "modeler/interpreter.h"
#include "modeler/look_text.h"
#include "modeler/script.h"
#include "tracer/scene_file.h"

namespace sir::fuzz {
namespace {

using modeler::Command;
using modeler::Interpreter;

// Commands that send thousands of rays, or do all of another script: so many a script. Trees double
// with two short commands: no further than this.
constexpr int kMostWork = 3;
constexpr std::size_t kMostNodes = 500, kMostPixels = 32 * 32;

bool works(std::string_view line) {
  const auto words = modeler::split_words(line);
  const modeler::CommandInfo* info = words.empty() ? nullptr : modeler::find_command(words[0]);
  if (info == nullptr) return false;
  return info->command == Command::show || info->command == Command::inspect ||
         info->command == Command::camera || info->command == Command::light ||
         info->command == Command::script || info->command == Command::load;
}

// Whether it asks for a picture that takes long; sizes are words such as 640x480.
bool is_large(std::string_view line) {
  for (const std::string& word : modeler::split_words(line)) {
    const auto cross = word.find_first_of("xX");
    std::int64_t width = 0, height = 0;
    if (cross != word.npos && parse_count(std::string_view(word).substr(0, cross), width) &&
        parse_count(std::string_view(word).substr(cross + 1), height) && width > 0 &&
        height > static_cast<std::int64_t>(kMostPixels) / width)
      return true;
  }
  return false;
}

bool has_large_solid(const Interpreter& interpreter) {
  for (const auto& [place, entry] : interpreter.solids().entries())
    if (entry->solid.tree()->count > kMostNodes) return true;
  return false;
}

modeler::Outlet outlet(ScratchFiles& files) {
  modeler::Outlet outlet;
  outlet.locate = [&](const std::string& named) { return files.locate(named); };
  outlet.write_picture = [](const std::filesystem::path&, const Planes&) {};
  outlet.draw = [](const Planes&, int columns) { return std::to_string(columns) + "\n"; };
  outlet.columns = [] { return 20; };
  return outlet;
}

// All solids in their order, and what they are looked at with; bit for bit.
std::string state_of(const Interpreter& interpreter) {
  std::string text;
  for (const auto& [place, entry] : interpreter.solids().entries())
    text += entry->name + "\n" + csg_text(modeler::to_csg(*entry->solid.tree()));
  const modeler::Looks& looks = interpreter.looks();
  return text + modeler::light_line(looks.lighting) + "\n" + surfaces_text(looks.surface_list());
}

std::string all_of(const Interpreter& interpreter) {
  std::string text =
      state_of(interpreter) + modeler::camera_line(interpreter.looks().camera) + "\n";
  for (const std::string& line : modeler::view_lines(interpreter.view())) text += line + "\n";
  return text + modeler::select_line(interpreter.selection());
}

// Runs the lines up to a quit; those that were done go into `done`.
void run(TextFile& file, Interpreter& interpreter, std::vector<std::string>& done) {
  modeler::Script script(interpreter, file.name(), [](const modeler::Reply&) {});
  int work = 0;
  while (file.next()) {
    try {
      if (is_large(file.line()) || (works(file.line()) && ++work > kMostWork)) continue;
    } catch (const modeler::CommandError&) {
      // Words that are none; the script says so.
    }
    try {
      const bool goes_on = script.line(file.line(), file.line_number());
      done.emplace_back(file.line());
      if (!goes_on || has_large_solid(interpreter)) return;
    } catch (const FileError& error) {
      // At the prompt one would go on.
      check_refusal(error, file.name(), std::string(file.line_number(), '\n'));
    }
  }
}

void run_again(const std::vector<std::string>& lines, Interpreter& interpreter) {
  for (const std::string& line : lines) interpreter.execute(line);
}

void check_undo(Interpreter& interpreter) {
  const std::string before = state_of(interpreter);
  const std::size_t steps = interpreter.undoable();
  for (std::size_t i = 0; i < steps; ++i) interpreter.execute("undo");
  require(interpreter.undoable() == 0, "what can be undone is undone");
  for (std::size_t i = 0; i < steps; ++i) interpreter.execute("redo");
  require(state_of(interpreter) == before, "what is undone and done again is as it was");
}

}  // namespace

void play_script(Bytes bytes) {
  static ScratchFiles files;
  files.clear();
  Interpreter interpreter(outlet(files));
  std::vector<std::string> done;
  TextFile file("F.model", std::string(text_of(bytes)));
  run(file, interpreter, done);
  const std::string all = all_of(interpreter);
  if (!files.used()) {
    Interpreter by_script(outlet(files));
    run_again(interpreter.script(), by_script);
    require(all_of(by_script) == all, "the script of a session makes what is there");
  }
  files.clear();
  Interpreter without_refused(outlet(files));
  run_again(done, without_refused);
  require(all_of(without_refused) == all, "a command that is refused has changed nothing");
  check_undo(interpreter);
}

}  // namespace sir::fuzz
