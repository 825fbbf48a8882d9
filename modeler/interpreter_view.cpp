// What is shown and what is selected: the thesis shows lines of one solid, on demand (3.2.2.9).
#include <fmt/format.h>

#include "modeler/arguments.h"
#include "modeler/command_error.h"
#include "modeler/inspect.h"
#include "modeler/interpreter.h"
#include "modeler/look_text.h"
#include "modeler/look_words.h"
#include "modeler/operations.h"
#include "tracer/names.h"
#include "tracer/text_file.h"

namespace sir::modeler {

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
  changed_ = true;
  return {{}, fmt::format("{}: {}", what, value ? "on" : "off"), {}, false};
}

Reply Interpreter::select_command(Arguments& words) {
  if (words.left() == 0) {
    selection_.reset();
    changed_ = true;
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
  changed_ = true;
  return {{}, std::move(done), {}, false};
}

}  // namespace sir::modeler
