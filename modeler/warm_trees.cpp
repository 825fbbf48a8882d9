#include "modeler/warm_trees.h"

#include <algorithm>
#include <cstddef>

namespace sir::modeler {
namespace {

constexpr std::size_t kMuchWork = std::size_t{1} << 15;  // nodes: some thousandths of a second
constexpr std::size_t kMostKept = std::size_t{1} << 13;  // nodes: a cache's worth

}  // namespace

void WarmTrees::done(const Changes& changes) {
  for (const Change& change : changes) replaced(change.before, change.after);
}

void WarmTrees::reverted(const Changes& changes) {
  for (const Change& change : changes) replaced(change.after, change.before);
}

void WarmTrees::replaced(const EntryPtr& gone, const EntryPtr& come) {
  std::erase_if(kept_, [&](const std::weak_ptr<const Entry>& kept) {
    const EntryPtr entry = kept.lock();
    return !entry || entry == gone || entry == come;
  });
  if (!gone) return;
  if (gone->solid.work() < kMuchWork) return gone->solid.forget_tree();
  kept_.push_back(gone);
  // From the last one back, as many as there is room for; the last whatever it takes.
  std::size_t room = kMostKept, last = kept_.size();
  while (last > 0) {
    const std::size_t count = kept_[last - 1].lock()->solid.count();
    if (count > room && last < kept_.size()) break;
    room -= std::min(room, count);
    --last;
  }
  for (; last > 0; --last) {
    kept_.front().lock()->solid.forget_tree();
    kept_.pop_front();
  }
}

}  // namespace sir::modeler
