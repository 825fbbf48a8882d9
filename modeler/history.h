// Undo and redo without limit. The thesis's modeler has neither: its "desfaz" takes a composite
// apart (3.2.2.6).
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "modeler/looks.h"
#include "modeler/lsu.h"
#include "modeler/warm_trees.h"

namespace sir::modeler {

/// The commands that changed solids, light or surfaces, each with what it changed: so many words a
/// command, however long the lists are. Solids that a command took away live until it can no longer
/// be undone.
class History {
 public:
  /// A command that changed nothing here, but wrote a file, say. Undo and redo pass over it.
  struct Note {
    std::string command;
    std::filesystem::path file;  ///< that was written
    bool uses_camera = false;
    std::optional<CameraFile> camera;  ///< the one it used; none: none was set
  };

  struct Record {
    std::string command;
    Changes changes;
    LookChanges look_changes;
    std::vector<Note> notes;  ///< what was done after it
  };

  /// Does it, and remembers it; what had been undone can no longer be redone.
  void commit(Lsu& solids, Looks& looks, Record record);

  /// Hangs a note on the last command that is in force.
  void add(Note note);

  /// What was done stays done, and what was undone stays undone: frees what only undo or redo could
  /// bring back. The commands stay, for a script.
  void forget();

  bool can_undo() const { return done_ > forgotten_; }
  bool can_redo() const { return done_ < records_.size(); }

  /// Where there is something to undo or redo. Returns what it was.
  const Record& undo(Lsu& solids, Looks& looks);
  const Record& redo(Lsu& solids, Looks& looks);

  /// The commands that are not undone, in order, and the notes before the first of them.
  std::span<const Record> in_force() const { return {records_.data(), done_}; }
  std::size_t undoable() const { return done_ - forgotten_; }
  const std::vector<Note>& first_notes() const { return first_notes_; }

 private:
  std::vector<Note> first_notes_;
  std::vector<Record> records_;
  std::size_t done_ = 0;       // the records before it are in force
  std::size_t forgotten_ = 0;  // those before it can no longer be undone
  WarmTrees trees_;
};

}  // namespace sir::modeler
