// save and load (thesis 3.2.2.7, 3.2.2.8).
#include <utility>

#include <fmt/format.h>

#include "modeler/arguments.h"
#include "modeler/command_error.h"
#include "modeler/csg.h"
#include "modeler/interpreter.h"
#include "modeler/look_files.h"
#include "modeler/operations.h"
#include "modeler/script_text.h"
#include "tracer/atomic_file.h"
#include "tracer/scene_file.h"
#include "tracer/scene_path.h"
#include "tracer/text_file.h"

namespace sir::modeler {
namespace {

using Path = std::filesystem::path;

}  // namespace

void Interpreter::protect(const Path& file) {
  protected_.push_back(file);
  std::erase(released_, file);
}

void Interpreter::release(const Path& file) { released_.push_back(file); }

Path Interpreter::file_word(Arguments& words) const { return outlet_.locate(words.next()); }

void Interpreter::require_writable(const Path& file) const {
  if (repeated_ != nullptr) return;
  for (const Path& input : protected_) refuse_same_file(file, input);
}

Reply Interpreter::save(Arguments& words) {
  const std::string name = words.next();
  const Path given = file_word(words);
  words.end();
  const EntryPtr solid = require(solids_, name);
  const Node& tree = *solid->solid.tree();
  const std::string suffix = suffix_of(given);
  const Path file = suffix == ".model" ? given : file_to_write(given, "CSG");
  require_writable(file);
  Reply reply;
  if (suffix == ".model") {
    write(file, script_text(tree, file.stem().string() + ".CSG"));
  } else {
    bool numbers_lost = false;
    const CsgTree nodes = to_csg(tree, &numbers_lost);
    write(file, csg_text(nodes));
    if (numbers_lost)
      reply.warnings.push_back(file.string() +
                               ": numbered anew, for not all nodes have numbers of their own");
  }
  solid->saved = true;
  reply.done = fmt::format("wrote {} ({})", file.string(), counted(tree.count, "node"));
  return noted(words, file, std::move(reply));
}

Changes Interpreter::load(const std::string& name, const Path& given) {
  TextFile file = read(given, "CSG");
  return insert(solids_, name, from_csg(read_csg(file)));
}

}  // namespace sir::modeler
