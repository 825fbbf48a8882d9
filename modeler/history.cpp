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

void History::forget() {
  records_.resize(done_);
  for (std::size_t i = forgotten_; i < done_; ++i) {
    records_[i].changes = {};
    records_[i].look_changes = {};
  }
  forgotten_ = done_;
}

const History::Record& History::undo(Lsu& solids, Looks& looks) {
  const Record& record = records_[--done_];
  revert(record.look_changes, looks);
  solids.revert(record.changes);
  trees_.reverted(record.changes);
  return record;
}

const History::Record& History::redo(Lsu& solids, Looks& looks) {
  const Record& record = records_[done_++];
  solids.apply(record.changes);
  trees_.done(record.changes);
  apply(record.look_changes, looks);
  return record;
}

}  // namespace sir::modeler
