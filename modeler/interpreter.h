// The one way in: every change of the modeler's state is a command, a line of text, whether it
// comes from a script, the prompt or a window (the thesis had menus, 3.2).
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "modeler/commands.h"
#include "modeler/history.h"
#include "modeler/lsu.h"
#include "tracer/planes.h"

namespace sir::modeler {

/// What a command has to say.
struct Reply {
  std::string text;                   ///< what was asked for, lines
  std::string done;                   ///< what has been done, a line without its end; at the prompt
  std::vector<std::string> warnings;  ///< lines for standard error
  bool quit = false;
};

/// What the interpreter has no means for.
struct Outlet {
  /// Writes a PNG. Throws FileError.
  std::function<void(const std::filesystem::path& file, const Planes& picture)> write_picture;
  /// A picture in coloured characters, of so many columns.
  std::function<std::string(const Planes& picture, int columns)> draw;
  /// Columns of the terminal.
  std::function<int()> columns = [] { return 80; };
  std::stop_token stop;  ///< ends a long show; no command is begun after it
};

/// Solids, what was done to them, and the commands that do it. For one thread.
class Interpreter {
 public:
  explicit Interpreter(Outlet outlet = {});

  /// Does what a line says; nothing for a blank one or a comment. Throws CommandError, or FileError
  /// where a file is to blame; then all is as before.
  Reply execute(std::string_view line);

  const Lsu& solids() const { return solids_; }

  /// The commands in force: a script that makes what is there now.
  std::vector<std::string> script() const { return history_.script(); }

  /// Names of the solids that have changed since they were saved, or never were.
  std::vector<std::string> unsaved() const;

  /// A file that is being read, which no command may overwrite.
  void protect(std::filesystem::path file) { protected_.push_back(std::move(file)); }

 private:
  class Arguments;
  Changes edit(const CommandInfo& info, Arguments& words, std::string& done) const;
  static NodeChange change(Command command, Arguments& words);
  static Step step(Command command, Arguments& words);
  Reply save(const std::string& name, const std::filesystem::path& file);
  Changes load(const std::string& name, const std::filesystem::path& file) const;
  Reply show(Arguments& words) const;
  Reply inspect(Arguments& words) const;
  Reply list() const;
  Reply take_back(bool again);
  Reply help(Arguments& words) const;
  void require_writable(const std::filesystem::path& file) const;

  Outlet outlet_;
  Lsu solids_;
  History history_;
  std::vector<std::filesystem::path> protected_;
};

}  // namespace sir::modeler
