#include "modeler/history.h"

#include <utility>

namespace sir::modeler {

void History::commit(Lsu& solids, Looks& looks, Record record) {
  records_.resize(done_);
  records_.push_back(std::move(record));
  redo(solids, looks);
}

void History::add(Note note) {
  (done_ == 0 ? first_notes_ : records_[done_ - 1].notes).push_back(std::move(note));
}

const History::Record& History::undo(Lsu& solids, Looks& looks) {
  const Record& record = records_[--done_];
  revert(record.look_changes, looks);
  solids.revert(record.changes);
  for (const Change& change : record.changes)
    if (change.after) change.after->solid.forget_tree();
  return record;
}

const History::Record& History::redo(Lsu& solids, Looks& looks) {
  const Record& record = records_[done_++];
  solids.apply(record.changes);
  apply(record.look_changes, looks);
  for (const Change& change : record.changes)
    if (change.before) change.before->solid.forget_tree();
  return record;
}

}  // namespace sir::modeler
