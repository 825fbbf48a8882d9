// Undo and redo without limit. The thesis's modeler has neither: its "desfaz" takes a composite
// apart (3.2.2.6).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "modeler/lsu.h"
#include "modeler/warm_trees.h"

namespace sir::modeler {

/// The commands that changed the list, each with what it changed: so many words a command, however
/// long the list is. Solids that a command took away live until it can no longer be undone.
class History {
 public:
  /// Does it, and remembers it; what had been undone can no longer be redone.
  void commit(Lsu& solids, std::string command, Changes changes);

  bool can_undo() const { return done_ > 0; }
  bool can_redo() const { return done_ < records_.size(); }

  /// Where there is something to undo or redo. Returns the command.
  const std::string& undo(Lsu& solids);
  const std::string& redo(Lsu& solids);

  /// The commands that are not undone, in order: a script that makes what is there now.
  std::vector<std::string> script() const;

 private:
  struct Record {
    std::string command;
    Changes changes;
  };
  std::vector<Record> records_;
  std::size_t done_ = 0;  // the records before it are in force
  WarmTrees trees_;
};

}  // namespace sir::modeler
