// What is shown, what is selected, and the script of all (the thesis has none of them).
#include <algorithm>

#include <fmt/format.h>

#include "modeler/arguments.h"
#include "modeler/command_error.h"
#include "modeler/inspect.h"
#include "modeler/interpreter.h"
#include "modeler/look_files.h"
#include "modeler/look_text.h"
#include "modeler/look_words.h"
#include "modeler/operations.h"
#include "tracer/atomic_file.h"
#include "tracer/scene_path.h"

namespace sir::modeler {

using Path = std::filesystem::path;

Reply Interpreter::view_command(Arguments& words) {
  if (words.left() == 0) {
    Reply reply;
    for (const auto& word : view_words())
      reply.text += fmt::format("{} {}\n", word.english, view_.*word.value ? "on" : "off");
    return reply;
  }
  const std::string what = words.next();
  bool ViewSettings::*const setting = value_of(view_words(), what, "part of the view");
  const bool value = value_of(switch_words(), words.next(), "state of a switch");
  words.end();
  view_.*setting = value;
  return {{}, fmt::format("{}: {}", what, value ? "on" : "off"), {}, false};
}

Reply Interpreter::select_command(Arguments& words) {
  if (words.left() == 0) {
    selection_.reset();
    return {{}, "nothing is selected", {}, false};
  }
  Selection chosen;
  chosen.solid = words.next();
  const NodePtr& tree = require(solids_, chosen.solid)->solid.tree();
  const Node* node = tree.get();
  if (words.left() > 0) {
    const std::int64_t place = words.count("place");
    if (place >= static_cast<std::int64_t>(tree->count))
      throw CommandError(fmt::format("{} has no place {}: it has {}, from 0 on",
                                     in_quotes(chosen.solid), place, counted(tree->count, "node")));
    chosen.place = static_cast<std::size_t>(place);
    node = node_at(*tree, chosen.place);
  }
  if (words.left() > 0) {
    const std::int64_t face = words.count("face");
    const Primitive* primitive = node->primitive();
    if (primitive == nullptr)
      throw CommandError(in_quotes(node->name) + " is a composite: faces are those of a primitive");
    const int faces = face_count(primitive->kind);
    if (face >= faces)
      throw CommandError(fmt::format("a {} has no face {}: it has {}, from 0 on",
                                     name_of(primitive->kind), face, counted(faces, "face")));
    chosen.face = static_cast<int>(face);
  }
  words.end();
  std::string done = in_quotes(chosen.solid);
  if (chosen.place > 0) done = fmt::format("{} of {}", in_quotes(node->name), done);
  done += ": " + type_text(*node);
  if (chosen.face)
    done += fmt::format(", face {}", face_name(node->primitive()->kind, *chosen.face));
  selection_ = std::move(chosen);
  return {{}, std::move(done), {}, false};
}

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

Reply Interpreter::script_command(Arguments& words) {
  std::string text;
  for (const std::string& line : script()) text += line + "\n";
  if (words.left() == 0) return {std::move(text), {}, {}, false};
  value_of(script_words(), words.next(), "word of script");
  const Path given = words.next();
  words.end();
  const Path file = given.has_extension() || is_device(given) ? given : with_suffix(given, "model");
  for (const Path& input : protected_)
    if (std::find(released_.begin(), released_.end(), input) == released_.end())
      refuse_same_file(file, input);
  // Run from there, the script could not write over itself.
  const auto refuse = [&](const std::vector<History::Note>& notes) {
    for (const History::Note& note : notes) {
      std::error_code missing;
      if (!is_device(file) && std::filesystem::equivalent(file, note.file, missing))
        throw CommandError(fmt::format("{} is what a command of the script writes: {}",
                                       in_quotes(file.string()), note.command));
    }
  };
  refuse(history_.first_notes());
  for (const History::Record& record : history_.in_force()) refuse(record.notes);
  write_file_atomically(file, text);
  for (const auto& [place, entry] : solids_.entries()) entry->saved = true;
  return {{}, "wrote " + file.string(), {}, false};
}

}  // namespace sir::modeler
