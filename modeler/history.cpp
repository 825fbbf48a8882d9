#include "modeler/history.h"

#include <utility>

namespace sir::modeler {

void History::commit(Lsu& solids, std::string command, Changes changes) {
  records_.resize(done_);
  records_.push_back({std::move(command), std::move(changes)});
  solids.apply(records_.back().changes);
  trees_.done(records_.back().changes);
  ++done_;
}

const std::string& History::undo(Lsu& solids) {
  const Record& record = records_[--done_];
  solids.revert(record.changes);
  trees_.reverted(record.changes);
  return record.command;
}

const std::string& History::redo(Lsu& solids) {
  const Record& record = records_[done_++];
  solids.apply(record.changes);
  trees_.done(record.changes);
  return record.command;
}

std::vector<std::string> History::script() const {
  std::vector<std::string> commands;
  for (std::size_t i = 0; i < done_; ++i) commands.push_back(records_[i].command);
  return commands;
}

}  // namespace sir::modeler
