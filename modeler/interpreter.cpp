#include "modeler/interpreter.h"

#include <utility>

#include <fmt/format.h>

#include "modeler/arguments.h"
#include "modeler/command_error.h"
#include "modeler/command_line.h"
#include "modeler/inspect.h"
#include "modeler/nearest_name.h"
#include "modeler/operations.h"
#include "tracer/names.h"
#include "tracer/text_file.h"

namespace sir::modeler {

Interpreter::Interpreter(Outlet outlet) : outlet_(std::move(outlet)) {}

Reply Interpreter::obey(std::string_view line) {
  std::vector<std::string> words = split_words(line);
  if (words.empty()) return {};
  if (line.find('\n') != line.npos) throw CommandError("a command is one line");
  if (outlet_.stop.stop_requested()) throw CommandError("interrupted");
  const CommandInfo* info = find_command(words.front());
  if (info == nullptr) {
    NearestName nearest(words.front());
    for (const CommandInfo& known : commands()) {
      nearest.offer(known.name);
      nearest.offer(known.portuguese);
    }
    throw CommandError("there is no command " + in_quotes(words.front()) +
                       (nearest.found() ? "; did you mean " + nearest.name() + "?"
                                        : "; help lists what there is"));
  }
  Arguments arguments(*info, std::move(words), std::string(without_comment(line)));
  const auto commit = [&](Changes changes, std::string done) {
    return record({arguments.text(), std::move(changes), {}, {}}, std::move(done));
  };
  switch (info->command) {
    case Command::create: {
      const std::string name = arguments.next();
      const PrimitiveKind kind = value_of(kinds(), arguments.next(), "primitive");
      std::vector<std::int64_t> surfaces{arguments.count("surface number")};
      while (arguments.left() > 0) surfaces.push_back(arguments.count("surface number"));
      return commit(create(solids_, name, kind, surfaces),
                    fmt::format("{}: {}", name, name_of(kind)));
    }
    case Command::transform:
    case Command::translate:
    case Command::scale:
    case Command::rotate:
    case Command::matrix:
    case Command::paint:
    case Command::operation:
    case Command::label:
    case Command::edit: {
      std::string done;
      Changes changes = edit(*info, arguments, done);
      return commit(std::move(changes), std::move(done));
    }
    case Command::combine: {
      const std::string name = arguments.next(), left = arguments.next();
      const Operation operation = value_of(modeler::operations(), arguments.next(), "operation");
      const std::string right = arguments.next();
      bool apart = false;
      if (arguments.left() > 0) {
        if (!is_word(arguments.next(), "apart", "separados")) arguments.fail();
        apart = true;
      }
      arguments.end();
      return watched(
          name, commit(combine(solids_, name, left, operation, right, apart),
                       fmt::format("{}: {} of {} and {}", name, name_of(operation), left, right)));
    }
    case Command::erase: {
      const std::string name = arguments.next();
      arguments.end();
      return commit(erase(solids_, name), name + ": deleted");
    }
    case Command::copy: {
      const std::string source = arguments.next(), destination = arguments.next();
      arguments.end();
      return commit(copy(solids_, source, destination),
                    fmt::format("{}: copy of {}", destination, source));
    }
    case Command::split: {
      const std::string name = arguments.next();
      arguments.end();
      Changes changes = split(solids_, name);
      const std::string left = changes[1].after->name, right = changes[2].after->name;
      return commit(std::move(changes),
                    fmt::format("{}: now {} and {}", name, in_quotes(left), in_quotes(right)));
    }
    case Command::rename: {
      const std::string name = arguments.next(), new_name = arguments.next();
      arguments.end();
      return commit(rename(solids_, name, new_name), fmt::format("{}: was {}", new_name, name));
    }
    case Command::number: {
      const std::string name = arguments.next();
      FileSlot slot;
      slot.number = arguments.count("number");
      if (arguments.left() > 0) slot.position = arguments.count("position");
      arguments.end();
      return commit(number(solids_, name, slot), fmt::format("{}: number {}", name, slot.number));
    }
    case Command::load: {
      const std::string name = arguments.next();
      const std::filesystem::path file = file_word(arguments);
      arguments.end();
      Changes changes = load(name, file);
      // What is read is kept in that file.
      const EntryPtr loaded = changes.front().after;
      loaded->saved = true;
      return commit(std::move(changes),
                    fmt::format("{}: {}", name, type_text(*loaded->solid.tree())));
    }
    case Command::save: return save(arguments);
    case Command::show: return show(arguments);
    case Command::inspect: return inspect(arguments);
    case Command::help: return help(arguments);
    case Command::list: arguments.end(); return list();
    case Command::camera: return camera_command(arguments);
    case Command::light: return light_command(arguments);
    case Command::surfaces: return surfaces_command(arguments);
    case Command::surface: return surface_command(arguments);
    case Command::view: return view_command(arguments);
    case Command::select: return select_command(arguments);
    case Command::script: return script_command(arguments);
    case Command::undo: return take_back(arguments, false);
    case Command::redo: return take_back(arguments, true);
    case Command::recover: return recover(arguments);
    case Command::forget:
      arguments.end();
      changed_ = true;
      history_.forget();
      return {{}, "what has been done can no longer be undone", {}, false};
    case Command::quit: {
      arguments.end();
      Reply reply;
      reply.quit = true;
      return reply;
    }
  }
  return {};
}

// A combination has been made: perhaps nothing is left, which is seldom meant.
Reply Interpreter::watched(const std::string& name, Reply reply) const {
  if (!watchful_ || repeated_ != nullptr) return reply;
  if (auto warning = empty_warning(*solids_.find(name)->solid.tree()))
    reply.warnings.push_back(std::move(*warning));
  return reply;
}

Reply Interpreter::take_back(Arguments& words, bool again) {
  if (words.left() > 0) {
    if (!is_word(words.next(), "camera", "câmera")) words.fail();
    words.end();
    return take_camera_back(again);
  }
  if (again ? !history_.can_redo() : !history_.can_undo())
    throw CommandError(again ? "there is nothing to redo" : "there is nothing to undo");
  const History::Record& record =
      again ? history_.redo(solids_, looks_) : history_.undo(solids_, looks_);
  follow(record.changes, !again);
  changed_ = true;
  return {{}, (again ? "done again: " : "undone: ") + record.command, {}, false};
}

Reply Interpreter::record(History::Record record, std::string done) {
  history_.commit(solids_, looks_, std::move(record));
  follow(history_.in_force().back().changes, false);
  changed_ = true;
  return {{}, std::move(done), {}, false};
}

Reply Interpreter::noted(const Arguments& words, const std::filesystem::path& file, Reply reply) {
  history_.add({words.text(), file, false, {}});
  changed_ = true;
  return reply;
}

Reply Interpreter::noted(const Arguments& words, const std::filesystem::path& file, Reply reply,
                         const std::optional<CameraFile>& used) {
  history_.add({words.text(), file, true, used});
  changed_ = true;
  return reply;
}

// The place where the selected solid stands holds another, of the same form, or none.
void Interpreter::follow(const Changes& changes, bool back) {
  if (!selection_) return;
  for (const Change& change : changes) {
    const EntryPtr& before = back ? change.after : change.before;
    const EntryPtr& after = back ? change.before : change.after;
    if (!before || before->name != selection_->solid) continue;
    if (after) selection_->solid = after->name;
    else selection_.reset();
    return;
  }
}

std::vector<std::string> Interpreter::unsaved() const {
  std::vector<std::string> names;
  for (const auto& [place, entry] : solids_.entries())
    if (!entry->saved) names.push_back(entry->name);
  return names;
}

}  // namespace sir::modeler
