// Trees that an undo or a redo is likely to ask for, kept for a while (Solid works out all others
// anew). The thesis keeps one state of the list.
#pragma once

#include <deque>
#include <memory>

#include "modeler/lsu.h"

namespace sir::modeler {

/// Forgets the trees of solids that have gone out of use, but of those that are much work the last
/// few, as far as memory allows.
class WarmTrees {
 public:
  /// These changes of the list have been done, or done the other way round.
  void done(const Changes& changes);
  void reverted(const Changes& changes);

 private:
  void replaced(const EntryPtr& gone, const EntryPtr& come);

  std::deque<std::weak_ptr<const Entry>> kept_;  // the last to go at the end
};

}  // namespace sir::modeler
