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

void Interpreter::Arguments::fail() const {
  throw CommandError(fmt::format("wrong number of words; it is {}{}{}{}", info_.name,
                                 info_.form.empty() ? "" : " ", info_.form,
                                 words_.size() > 2 ? " (a name with spaces goes in quotes)" : ""));
}

double Interpreter::Arguments::number() {
  const std::string& word = next();
  double value = 0;
  if (!parse_number(word, value)) throw CommandError(in_quotes(word) + " is not a finite number");
  return value;
}

std::int64_t Interpreter::Arguments::count(const char* what) {
  const std::string& word = next();
  std::int64_t value = 0;
  if (!parse_count(word, value))
    throw CommandError(std::string(what) + " " + in_quotes(word) +
                       " is not a non-negative integer");
  return value;
}

std::vector<double> Interpreter::Arguments::numbers() {
  std::vector<double> values;
  while (left() > 0) values.push_back(number());
  return values;
}

Interpreter::Interpreter(Outlet outlet) : outlet_(std::move(outlet)) {}

Reply Interpreter::execute(std::string_view line) {
  std::vector<std::string> words = split_words(line);
  if (words.empty()) return {};
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
  Arguments arguments(*info, std::move(words));
  const auto commit = [&](Changes changes, std::string done) {
    history_.commit(solids_, std::string(without_comment(line)), std::move(changes));
    return Reply{{}, std::move(done), {}, false};
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
    case Command::save: {
      const std::string name = arguments.next(), file = arguments.next();
      arguments.end();
      return save(name, file);
    }
    case Command::show: return show(arguments);
    case Command::inspect: return inspect(arguments);
    case Command::help: return help(arguments);
    case Command::list: arguments.end(); return list();
    case Command::undo: arguments.end(); return take_back(false);
    case Command::redo: arguments.end(); return take_back(true);
    case Command::quit: {
      arguments.end();
      Reply reply;
      reply.quit = true;
      return reply;
    }
  }
  return {};
}

Reply Interpreter::take_back(bool again) {
  if (again ? !history_.can_redo() : !history_.can_undo())
    throw CommandError(again ? "there is nothing to redo" : "there is nothing to undo");
  const std::string& command = again ? history_.redo(solids_) : history_.undo(solids_);
  return {{}, (again ? "done again: " : "undone: ") + command, {}, false};
}

std::vector<std::string> Interpreter::unsaved() const {
  std::vector<std::string> names;
  for (const auto& [place, entry] : solids_.entries())
    if (!entry->saved) names.push_back(entry->name);
  return names;
}

}  // namespace sir::modeler
