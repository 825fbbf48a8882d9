// The script of a session: all that is there, as commands (the thesis has none, 3.2).
#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "modeler/arguments.h"
#include "modeler/command_error.h"
#include "modeler/interpreter.h"
#include "modeler/look_files.h"
#include "modeler/look_text.h"
#include "modeler/look_words.h"
#include "modeler/script.h"
#include "tracer/atomic_file.h"
#include "tracer/scene_file.h"
#include "tracer/scene_path.h"

namespace sir::modeler {
namespace {

using Path = std::filesystem::path;

std::string text_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

// A script that is being loaded, maybe by another. A few scripts that each load the next one twice
// would go on for ever.
class Nest {
 public:
  Nest() {
    constexpr int kMostDeep = 32, kMostScripts = 1000;
    if (deep_ == 0) scripts_ = 0;
    if (deep_ == kMostDeep)
      throw CommandError("scripts load each other at most " + std::to_string(kMostDeep) + " deep");
    if (scripts_ > kMostScripts)
      throw CommandError("a script that is loaded may lead to at most " +
                         std::to_string(kMostScripts) + " more");
    ++deep_;
    ++scripts_;
  }
  ~Nest() { --deep_; }
  Nest(const Nest&) = delete;
  Nest& operator=(const Nest&) = delete;

 private:
  static thread_local int deep_, scripts_;
};

thread_local int Nest::deep_ = 0;
thread_local int Nest::scripts_ = 0;

}  // namespace

std::vector<std::string> Interpreter::script() const {
  std::vector<std::string> lines;
  std::optional<CameraFile> camera;  // as the lines so far have it
  const auto lead = [&](const std::optional<CameraFile>& wanted) {
    if (same(camera, wanted)) return;
    lines.push_back(camera_line(wanted));
    camera = wanted;
  };
  const auto add = [&](const std::vector<History::Note>& notes) {
    for (const History::Note& note : notes) {
      if (note.uses_camera) lead(note.camera);
      lines.push_back(note.command);
    }
  };
  add(history_.first_notes());
  for (const History::Record& record : history_.in_force()) {
    lines.push_back(record.command);
    add(record.notes);
  }
  lead(looks_.camera);
  for (std::string& line : view_lines(view_)) lines.push_back(std::move(line));
  if (selection_) lines.push_back(select_line(selection_));
  return lines;
}

std::vector<Path> Interpreter::being_read() const {
  std::vector<Path> files;
  for (const Path& file : protected_)
    if (std::find(released_.begin(), released_.end(), file) == released_.end())
      files.push_back(file);
  return files;
}

Reply Interpreter::script_command(Arguments& words) {
  if (words.left() == 0) return {text_of(script()), {}, {}, false};
  const ScriptWord word = value_of(script_words(), words.next(), "word of script");
  const Path file = file_word(words);
  words.end();
  return word == ScriptWord::load ? load_script(file) : save_script(file);
}

Reply Interpreter::load_script(const Path& given) {
  std::error_code ignored;
  const Path with_model = with_suffix(given, "model");
  const bool there = std::filesystem::is_regular_file(given, ignored) || is_device(given) ||
                     (given.has_extension() && !std::filesystem::exists(with_model, ignored));
  const Path file = there ? given : with_model;
  TextFile text = read([&] { return TextFile(file); });
  for (const Path& input : being_read())
    if (std::filesystem::equivalent(file, input, ignored))
      throw CommandError(in_quotes(file.string()) + " is being read: it cannot load itself");
  const Nest nest;
  const Interpreter before = *this;
  Reply all;
  protect(file);
  watch(false);
  hold_camera();
  try {
    run_script(text, *this, [&](const Reply& reply) {
      all.text += reply.text;
      all.warnings.insert(all.warnings.end(), reply.warnings.begin(), reply.warnings.end());
    });
  } catch (...) {
    *this = before;
    throw;
  }
  let_go_of_camera();
  watch(before.watchful_);
  release(file);
  all.done = "did what " + file.string() + " says";
  return all;
}

Reply Interpreter::save_script(const Path& given) {
  const Path file = file_to_write(given, "model");
  if (repeated_ == nullptr)
    for (const Path& input : being_read()) refuse_same_file(file, input);
  // Run from there, the script could not write over itself.
  const auto refuse = [&](const std::vector<History::Note>& notes) {
    for (const History::Note& note : notes) {
      std::error_code missing;
      if (repeated_ == nullptr && !is_device(file) &&
          std::filesystem::equivalent(file, note.file, missing))
        throw CommandError(fmt::format("{} is what a command of the script writes: {}",
                                       in_quotes(file.string()), note.command));
    }
  };
  refuse(history_.first_notes());
  for (const History::Record& record : history_.in_force()) refuse(record.notes);
  write(file, text_of(script()));
  for (const auto& [place, entry] : solids_.entries()) entry->saved = true;
  saved_light_ = light_line(looks_.lighting);
  saved_surfaces_ = surfaces_text(looks_.surface_list());
  changed_ = true;
  return {{}, "wrote " + file.string(), {}, false};
}

}  // namespace sir::modeler
