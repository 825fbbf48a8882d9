// The commands that change a solid, or a part of it where it is: transforms, paint, operation,
// label, edit (thesis 3.2.2.2, 3.2.2.6).
#include <utility>

#include <fmt/format.h>

#include "modeler/arguments.h"
#include "modeler/command_error.h"
#include "modeler/command_line.h"
#include "modeler/interpreter.h"
#include "modeler/nearest_name.h"
#include "modeler/operations.h"
#include "tracer/names.h"
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

// The place that a word stands for.
std::size_t place_of(const Node& tree, const std::string& name, const std::string& word) {
  std::int64_t place = 0;
  if (!parse_count(word, place)) {
    const std::vector<const Node*> nodes = preorder(tree);
    NearestName nearest(word);
    for (const Node* node : nodes) nearest.offer(node->name);
    std::string hint = fmt::format("; inspect {} tree shows them", as_word(name));
    for (std::size_t i = 0; nearest.found() && i < nodes.size(); ++i)
      if (nodes[i]->name == nearest.name()) {
        hint = fmt::format("; {} is at place {}", in_quotes(nearest.name()), i);
        break;
      }
    throw CommandError(in_quotes(word) + " is no place in the tree, a number" + hint);
  }
  if (static_cast<std::size_t>(place) >= tree.count)
    throw CommandError(fmt::format("there is no place {} in {}: {}", place, in_quotes(name),
                                   tree.count == 1
                                       ? std::string("it is a primitive, its place 0")
                                       : fmt::format("its places are 0 to {}", tree.count - 1)));
  return static_cast<std::size_t>(place);
}

const CommandInfo& part_command(const std::string& word) {
  const CommandInfo* info = find_command(word);
  if (info != nullptr && is_for_parts(info->command)) return *info;
  std::string names;
  NearestName nearest(word);
  for (const CommandInfo& known : commands()) {
    if (!is_for_parts(known.command)) continue;
    names += (names.empty() ? "" : ", ") + std::string(known.name);
    nearest.offer(known.name);
    nearest.offer(known.portuguese);
  }
  throw CommandError(fmt::format(
      "{} is nothing that can be done to a part: {}{}", in_quotes(word), names,
      info == nullptr && nearest.found() ? "; did you mean " + nearest.name() + "?" : ""));
}

// The form of a part's command as it stands in an edit.
std::string form_for_parts(const CommandInfo& info) {
  constexpr std::string_view kName = "NAME ";
  std::string form(info.form);
  for (auto at = form.find(kName); at != form.npos; at = form.find(kName, at))
    form.erase(at, kName.size());
  return fmt::format("NAME PLACE {} {}", info.name, form);
}

std::string done_text(const NodeChange& change) {
  if (std::holds_alternative<Step>(change)) return "transformed";
  if (std::holds_alternative<Paint>(change)) return "painted";
  if (const Label* label = std::get_if<Label>(&change))
    return in_quotes(label->text) + " in the .CSG";
  return std::string(name_of(std::get<Operation>(change)));
}

}  // namespace

// The words that may stand at a change's end.
void Interpreter::take_ends(Command command, bool in_place, Arguments& words, Edit& edit) {
  if (in_place || command == Command::operation) edit.apart = words.take_last("apart", "separados");
  switch (command) {
    case Command::transform:
    case Command::scale:
    case Command::rotate: edit.about_centre = words.take_last("centre", "centro"); break;
    default: break;
  }
}

Changes Interpreter::edit(const CommandInfo& info, Arguments& words, std::string& done) const {
  const std::string name = words.next();
  const EntryPtr solid = require(solids_, name);  // first: what is wrong first is said first
  Edit edit;
  std::string part;
  if (info.command != Command::edit) {
    take_ends(info.command, false, words, edit);
    edit.change = change(info.command, words);
  } else {
    const NodePtr& tree = solid->solid.tree();
    edit.place = place_of(*tree, name, words.next());
    const CommandInfo& command = part_command(words.next());
    const std::string form = form_for_parts(command);
    CommandInfo shown = info;
    shown.form = form;
    std::vector<std::string> rest{std::string(info.name)};
    while (words.left() > 0) rest.push_back(words.next());
    Arguments its_words(shown, std::move(rest), words.text());
    take_ends(command.command, true, its_words, edit);
    edit.change = change(command.command, its_words);
    part = fmt::format("{} at {}: ", in_quotes(node_at(*tree, edit.place)->name), edit.place);
  }
  done = fmt::format("{}: {}{}", name, part, done_text(edit.change));
  return modeler::edit(solids_, name, std::move(edit));
}

NodeChange Interpreter::change(Command command, Arguments& words) {
  switch (command) {
    case Command::paint: {
      Paint paint;
      do paint.surfaces.push_back(words.count("surface number"));
      while (words.left() > 0);
      return paint;
    }
    case Command::operation: {
      const Operation operation = value_of(operations(), words.next(), "operation");
      words.end();
      return operation;
    }
    case Command::label: {
      Label label{words.next()};
      words.end();
      return label;
    }
    default: return step(command, words);
  }
}

Step Interpreter::step(Command command, Arguments& words) {
  Step::Kind kind = Step::Kind::matrix;
  if (command == Command::transform) kind = value_of(transforms(), words.next(), "transform");
  if (command == Command::translate) kind = Step::Kind::translation;
  if (command == Command::scale) kind = Step::Kind::scale;
  if (command == Command::rotate) kind = Step::Kind::rotation;
  switch (kind) {
    case Step::Kind::translation: {
      const auto way = words.numbers();
      if (way.size() != 3) words.fail();
      return translation_by({way[0], way[1], way[2]});
    }
    case Step::Kind::scale: {
      const auto factors = words.numbers();
      if (factors.size() != 1 && factors.size() != 3) words.fail();
      for (const double factor : factors)
        if (factor == 0) throw CommandError("a scale of 0 would leave nothing of a solid");
      return scale_by(factors.size() == 1 ? glm::dvec3(factors[0])
                                          : glm::dvec3(factors[0], factors[1], factors[2]));
    }
    case Step::Kind::rotation: {
      const int axis = axis_of(words.next());
      const double degrees = words.number();
      words.end();
      return rotation_about(axis, degrees);
    }
    case Step::Kind::matrix: break;
  }
  const auto numbers = words.numbers();
  if (numbers.size() != 12 && numbers.size() != 16) words.fail();
  return matrix_of(placement_of(numbers));
}

}  // namespace sir::modeler
