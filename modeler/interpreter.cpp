#include "modeler/interpreter.h"

#include <utility>

#include <fmt/format.h>

#include "modeler/arguments.h"
#include "modeler/command_error.h"
#include "modeler/command_line.h"
#include "modeler/nearest_name.h"
#include "modeler/operations.h"
#include "tracer/text_file.h"

namespace sir::modeler {

namespace {

int axis_of(const std::string& word) {
  constexpr std::string_view kAxes[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis)
    if (is_word(word, kAxes[axis], kAxes[axis])) return axis;
  throw CommandError(in_quotes(word) + " is no axis: x, y or z");
}

// Twelve numbers, or sixteen with the fourth column.
Placement placement_of(const std::vector<double>& m) {
  const std::size_t width = m.size() / 4;
  Placement lines;
  for (std::size_t line = 0; line < 4; ++line) {
    const double* at = m.data() + line * width;
    const glm::dvec3 v(at[0], at[1], at[2]);
    if (line < 3) lines.linear[static_cast<int>(line)] = v;
    else lines.translation = v;
    if (width == 4 && at[3] != (line == 3 ? 1.0 : 0.0))
      throw CommandError("the fourth column of a matrix must be 0 0 0 1");
  }
  return lines;
}

}  // namespace

Interpreter::Interpreter(Outlet outlet) : outlet_(std::move(outlet)) {}

Reply Interpreter::execute(std::string_view line) {
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
    case Command::matrix: {
      const std::string name = arguments.next();
      Step::Kind kind = Step::Kind::matrix;
      if (info->command == Command::transform)
        kind = value_of(transforms(), arguments.next(), "transform");
      if (info->command == Command::translate) kind = Step::Kind::translation;
      if (info->command == Command::scale) kind = Step::Kind::scale;
      if (info->command == Command::rotate) kind = Step::Kind::rotation;
      return commit(transform(kind, name, arguments), name + ": transformed");
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
      return commit(combine(solids_, name, left, operation, right, apart),
                    fmt::format("{}: {} of {} and {}", name, name_of(operation), left, right));
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
    case Command::label: {
      const std::string name = arguments.next(), text = arguments.next();
      arguments.end();
      return commit(label(solids_, name, text),
                    fmt::format("{}: {} in the .CSG", name, in_quotes(text)));
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
      const std::string name = arguments.next(), file = arguments.next();
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
    case Command::quit: {
      arguments.end();
      Reply reply;
      reply.quit = true;
      return reply;
    }
  }
  return {};
}

Changes Interpreter::transform(Step::Kind kind, const std::string& name, Arguments& words) const {
  require(solids_, name);  // before the numbers: what is wrong first is said first
  switch (kind) {
    case Step::Kind::translation: {
      const auto way = words.numbers();
      if (way.size() != 3) words.fail();
      return modeler::transform(solids_, name, translation_by({way[0], way[1], way[2]}));
    }
    case Step::Kind::scale: {
      const auto factors = words.numbers();
      if (factors.size() != 1 && factors.size() != 3) words.fail();
      for (const double factor : factors)
        if (factor == 0) throw CommandError("a scale of 0 would leave nothing of a solid");
      return modeler::transform(
          solids_, name,
          scale_by(factors.size() == 1 ? glm::dvec3(factors[0])
                                       : glm::dvec3(factors[0], factors[1], factors[2])));
    }
    case Step::Kind::rotation: {
      const int axis = axis_of(words.next());
      const double degrees = words.number();
      words.end();
      return modeler::transform(solids_, name, rotation_about(axis, degrees));
    }
    case Step::Kind::matrix: {
      const auto numbers = words.numbers();
      if (numbers.size() != 12 && numbers.size() != 16) words.fail();
      return modeler::transform(solids_, name, matrix_of(placement_of(numbers)));
    }
  }
  return {};
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
  return {{}, (again ? "done again: " : "undone: ") + record.command, {}, false};
}

Reply Interpreter::record(History::Record record, std::string done) {
  history_.commit(solids_, looks_, std::move(record));
  follow(history_.in_force().back().changes, false);
  return {{}, std::move(done), {}, false};
}

Reply Interpreter::noted(const Arguments& words, const std::filesystem::path& file, Reply reply) {
  history_.add({words.text(), file, false, {}});
  return reply;
}

Reply Interpreter::noted(const Arguments& words, const std::filesystem::path& file, Reply reply,
                         const std::optional<CameraFile>& used) {
  history_.add({words.text(), file, true, used});
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
