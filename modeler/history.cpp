#include "modeler/history.h"

#include <utility>

namespace sir::modeler {

void History::commit(Lsu& solids, std::string command, Changes changes) {
  records_.resize(done_);
  records_.push_back({std::move(command), std::move(changes)});
  solids.apply(records_.back().changes);
  for (const Change& change : records_.back().changes)
    if (change.before) change.before->solid.forget_tree();
  ++done_;
}

const std::string& History::undo(Lsu& solids) {
  const Record& record = records_[--done_];
  solids.revert(record.changes);
  for (const Change& change : record.changes)
    if (change.after) change.after->solid.forget_tree();
  return record.command;
}

const std::string& History::redo(Lsu& solids) {
  const Record& record = records_[done_++];
  solids.apply(record.changes);
  for (const Change& change : record.changes)
    if (change.before) change.before->solid.forget_tree();
  return record.command;
}

std::vector<std::string> History::script() const {
  std::vector<std::string> commands;
  for (std::size_t i = 0; i < done_; ++i) commands.push_back(records_[i].command);
  return commands;
}

}  // namespace sir::modeler
