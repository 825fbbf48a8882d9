// The one way in: every change of the modeler's state is a command, a line of text, whether it
// comes from a script, the prompt or a window (the thesis had menus, 3.2).
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "modeler/camera_history.h"
#include "modeler/commands.h"
#include "modeler/deed.h"
#include "modeler/history.h"
#include "modeler/looks.h"
#include "modeler/lsu.h"
#include "tracer/planes.h"
#include "tracer/text_file.h"

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
  /// Where a file is that a command names; the working folder's by default. Throws FileError or
  /// CommandError for one that is out of reach.
  std::function<std::filesystem::path(const std::string& named)> locate =
      [](const std::string& named) { return std::filesystem::path(named); };
  /// Columns of the terminal.
  std::function<int()> columns = [] { return 80; };
  std::stop_token stop;  ///< ends a long show or inspect; no command is begun after it
};

/// Who keeps what is done, so that it is there after a crash (see keeper.h).
struct Keeping {
  /// Hears of each command that changed something, be it that it wrote a file. Returns what a
  /// person should be told, "" as a rule. Throws nothing.
  std::function<std::string(const Deed& deed)> done;
  /// Does `recover` with the words behind it.
  std::function<Reply(const std::vector<std::string>& words)> recover;
  /// The names of the sessions that can be recovered.
  std::function<std::vector<std::string>()> names;
};

/// Solids, how they are looked at, what was done to them, and the commands that do it. For one
/// thread.
class Interpreter {
 public:
  explicit Interpreter(Outlet outlet = {});

  /// Does what a line says; nothing for a blank one or a comment. Throws CommandError, or FileError
  /// where a file is to blame; then all is as before.
  Reply execute(std::string_view line);

  /// From here on tells of what is done; a script's commands as those that they are, but for
  /// `script load`, which is one.
  void keep(Keeping keeping) { keeping_ = std::move(keeping); }
  const Keeping& keeping() const { return keeping_; }

  /// Does again what was done once: reads what was read then, and writes nothing, for that is
  /// written. Nobody hears of it. Throws as execute().
  void repeat(const Deed& deed);

  /// As at the beginning, but with the same means, and told of to the same keeper.
  void clear();

  /// Whether a combination that leaves nothing is told of at once, which takes some rays: for
  /// hands, not for scripts of a hundred thousand commands. Returns how it was.
  bool watch(bool watchful) { return std::exchange(watchful_, watchful); }

  const Lsu& solids() const { return solids_; }

  /// Camera, light and surfaces that were set by commands.
  const Looks& looks() const { return looks_; }

  /// The camera that was set, else one that has in its window all that there was when it was first
  /// asked for.
  CameraFile camera() const;

  /// The light that was set, else the one that is made up for camera().
  Lighting lighting() const;

  /// What is to be seen, and the node, or face, that is selected: always one that is there.
  const ViewSettings& view() const { return view_; }
  const std::optional<Selection>& selection() const { return selection_; }

  /// A script that makes what is there now: the commands in force that changed solids, light and
  /// surfaces, among them those that wrote files, and at the end a line for the camera, lines for
  /// the view and one for the selection, where they are not as at first.
  std::vector<std::string> script() const;

  /// How many commands `undo` can take back. Those for camera, view and selection are not among
  /// them: who edits, goes around to look and then undoes wants the edit undone.
  std::size_t undoable() const { return history_.undoable(); }

  /// A hand moves the camera: until it lets go, `undo camera` takes back all its commands as one.
  void hold_camera() { camera_history_.hold(); }
  void let_go_of_camera() { camera_history_.let_go(); }

  /// Names of the solids that have changed since they were saved, or never were.
  std::vector<std::string> unsaved() const;

  /// Whether light or surfaces that were set are in no file as they are.
  bool looks_unsaved() const;

  bool interrupted() const { return outlet_.stop.stop_requested(); }

  /// A file that is being read, which no command may overwrite.
  void protect(const std::filesystem::path& file);

  /// A script that has been read to its end: `script save` may overwrite it, nothing else.
  void release(const std::filesystem::path& file);

 private:
  class Arguments;
  Reply obey(std::string_view line);
  TextFile read(const std::filesystem::path& file, std::string_view suffix);
  TextFile read(const std::function<TextFile()>& open);
  void write(const std::filesystem::path& file, std::string_view text) const;
  Changes edit(const CommandInfo& info, Arguments& words, std::string& done) const;
  static void take_ends(Command command, bool in_place, Arguments& words, Edit& edit);
  static NodeChange change(Command command, Arguments& words);
  static Step step(Command command, Arguments& words);
  Reply save(Arguments& words);
  Changes load(const std::string& name, const std::filesystem::path& file);
  Reply show(Arguments& words);
  Reply recover(Arguments& words);
  Reply inspect(Arguments& words) const;
  Reply list() const;
  Reply help(Arguments& words) const;
  Reply take_back(Arguments& words, bool again);

  Reply camera_command(Arguments& words);
  CameraFile described_camera(Arguments& words) const;
  Reply set_camera(std::optional<CameraFile> camera, std::string done);
  Reply take_camera_back(bool again);
  Reply light_command(Arguments& words);
  Reply change_light(const Arguments& words, LookChange change, std::string done);
  Reply surfaces_command(Arguments& words);
  Reply surface_command(Arguments& words);
  Reply view_command(Arguments& words);
  Reply select_command(Arguments& words);
  Reply script_command(Arguments& words);
  Reply load_script(const std::filesystem::path& file);
  Reply save_script(const std::filesystem::path& file);

  Reply watched(const std::string& name, Reply reply) const;
  Reply record(History::Record record, std::string done);
  Reply noted(const Arguments& words, const std::filesystem::path& file, Reply reply);
  Reply noted(const Arguments& words, const std::filesystem::path& file, Reply reply,
              const std::optional<CameraFile>& used);
  void follow(const Changes& changes, bool back);
  std::filesystem::path file_word(Arguments& words) const;
  void require_writable(const std::filesystem::path& file) const;
  std::vector<std::filesystem::path> being_read() const;

  Outlet outlet_;
  bool watchful_ = false;
  Lsu solids_;
  Looks looks_;
  History history_;
  CameraHistory camera_history_;
  ViewSettings view_;
  std::optional<Selection> selection_;
  mutable std::optional<CameraFile> made_up_camera_;  // once it has been asked for
  std::vector<std::filesystem::path> protected_;
  std::vector<std::filesystem::path> released_;  // of those
  std::string saved_light_, saved_surfaces_;     // as they are in a file

  Keeping keeping_;
  bool within_ = false;   // a command that is told of when it is done
  bool changed_ = false;  // it has changed something
  std::vector<TextRead> reads_;
  std::optional<CameraFile> told_camera_;  // made up, as the keeper knows it
  const Deed* repeated_ = nullptr;         // what is being done again
  std::size_t next_read_ = 0;
};

}  // namespace sir::modeler
