// Everything that the modeler can be told, in one table: reading, help and completion come from
// it. English names and the thesis's (3.2); those that the thesis lacks are in Portuguese too.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "modeler/inspect.h"
#include "modeler/step.h"
#include "tracer/scene.h"

namespace sir::modeler {

enum class Command : std::uint8_t {
  create,
  transform,
  translate,
  scale,
  rotate,
  matrix,
  paint,
  combine,
  operation,
  edit,
  erase,
  copy,
  split,
  rename,
  label,
  number,
  save,
  load,
  show,
  inspect,
  camera,
  light,
  surfaces,
  surface,
  view,
  select,
  list,
  script,
  undo,
  redo,
  forget,
  recover,
  help,
  quit
};

/// A command as a person meets it.
struct CommandInfo {
  Command command;
  std::string_view name, portuguese;
  std::string_view form;  ///< the arguments
  std::string_view help;  ///< what it does, in a sentence or two
  /// What can stand in each place, for completion; the last goes on: n a new name, s a solid, k a
  /// kind, o an operation, t a transform, x an axis, m the word centre, f a file, a an aspect, c a
  /// command, N a place in the solid's tree, E a command for what is there and what that takes, - a
  /// number; C, L, U, F, T what stands behind camera, light, surfaces, surface NUMBER, script;
  /// J a session that can be recovered; V a part of the view, O on or off; h the word camera.
  std::string_view places;
};

/// All commands, in the order of the help.
std::span<const CommandInfo> commands();

/// Whether a command can be that of an edit, where PLACE stands for its NAME.
bool is_for_parts(Command command);

/// By either name, without case and accents; null where there is none.
const CommandInfo* find_command(std::string_view word);

/// A value that is written as one of a few words, English or Portuguese, without case and accents.
template <typename Value>
struct Word {
  std::string_view english, portuguese;
  Value value;
};
std::span<const Word<PrimitiveKind>> kinds();
std::span<const Word<Operation>> operations();
std::span<const Word<Step::Kind>> transforms();
std::span<const Word<Aspect>> aspects();

/// The value of a word; throws CommandError that names what `what` can be, and the nearest.
template <typename Value>
Value value_of(std::span<const Word<Value>> words, std::string_view word, std::string_view what);

/// Whether a word is written so, in either language.
bool is_word(std::string_view word, std::string_view english, std::string_view portuguese);

/// "scale NAME x y z" with its Portuguese name and what it does.
std::string help_text(const CommandInfo& info);

/// All commands, a line each.
std::string help_text();

}  // namespace sir::modeler
