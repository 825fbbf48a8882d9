#include "modeler/playback.h"

#include <algorithm>

#include "modeler/command_error.h"
#include "modeler/command_line.h"
#include "modeler/commands.h"
#include "tracer/error.h"
#include "tracer/text_file.h"

namespace sir::modeler {
namespace {

// The commands that could be undone and done again in the session: of each, whether it has been
// done here too.
class Undoable {
 public:
  // Whether the session's undo, or redo, is to be one here.
  bool undo() { return move(done_, undone_); }
  bool redo() { return move(undone_, done_); }

  // After any other command there were so many.
  void settle(std::size_t count, bool done) {
    if (count == done_.size()) return;
    undone_.clear();
    if (count < done_.size()) done_.clear();  // forgotten
    done_.resize(count, done);
  }

  // There are so many, all of them done here.
  void begin_anew(std::size_t count) {
    undone_.clear();
    done_.assign(count, true);
  }

 private:
  static bool move(std::vector<bool>& from, std::vector<bool>& to) {
    if (from.empty()) return true;  // no journal has that; it is refused
    const bool done = from.back();
    from.pop_back();
    to.push_back(done);
    return done;
  }

  std::vector<bool> done_, undone_;
};

enum class Kind { undo, redo, nothing, other };

Kind kind_of(const std::string& command) {
  const std::vector<std::string> words = split_words(command);
  if (words.empty()) return Kind::nothing;
  const CommandInfo* info = words.size() == 1 ? find_command(words.front()) : nullptr;
  if (info == nullptr) return Kind::other;
  if (info->command == Command::undo) return Kind::undo;
  return info->command == Command::redo ? Kind::redo : Kind::other;
}

}  // namespace

Playback play_back(const std::string& name, const Journal& journal, Interpreter& interpreter) {
  Playback result;
  Undoable undoable;
  for (const auto& [deed, line] : journal.entries) {
    if (interpreter.interrupted()) throw CommandError("interrupted");
    bool done = true;
    const auto refuse = [&](const std::exception& error) {
      if (interpreter.interrupted()) throw CommandError("interrupted");
      done = false;
      result.failed.push_back(
          FileError(name, line, std::string(error.what()) + ": " + visible(deed.command)).what());
    };
    try {
      const Kind kind = kind_of(deed.command);
      if (kind == Kind::nothing) {
        undoable.begin_anew(deed.undoable);
        continue;
      }
      const bool here = kind == Kind::undo   ? undoable.undo()
                        : kind == Kind::redo ? undoable.redo()
                                             : true;
      if (here) interpreter.repeat(deed);
    } catch (const CommandError& error) {
      refuse(error);
    } catch (const FileError& error) {
      refuse(error);
    }
    undoable.settle(deed.undoable, done);
    if (done) ++result.done;
  }
  interpreter.let_go_of_camera();
  return result;
}

}  // namespace sir::modeler
