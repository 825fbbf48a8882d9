#include "modeler/lsu.h"

#include <algorithm>

namespace sir::modeler {

EntryPtr Lsu::find(std::string_view name) const {
  const auto found = places_.find(name);
  return found == places_.end() ? nullptr : entries_.at(found->second);
}

Place Lsu::place_of(std::string_view name) const { return places_.find(name)->second; }

void Lsu::apply(const Changes& changes) {
  // A name may move from one solid to another: first all go, then all come.
  for (const Change& change : changes)
    if (change.before) remove(change.place, *change.before);
  for (const Change& change : changes)
    if (change.after) put(change.place, change.after);
}

void Lsu::revert(const Changes& changes) {
  for (const Change& change : changes)
    if (change.after) remove(change.place, *change.after);
  for (const Change& change : changes)
    if (change.before) put(change.place, change.before);
}

void Lsu::remove(Place place, const Entry& entry) {
  entries_.erase(place);
  places_.erase(entry.name);
}

void Lsu::put(Place place, const EntryPtr& entry) {
  entries_.insert_or_assign(place, entry);
  places_.insert_or_assign(entry->name, place);
  next_ = std::max(next_, place + 1);
}

}  // namespace sir::modeler
