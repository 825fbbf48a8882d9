// What stands in a journal: a session's commands, each with what it read, in the order in which
// they were done. The thesis's modeler keeps nothing of a session (3.2).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "modeler/deed.h"

namespace sir::modeler {

/// How the session began.
struct JournalHead {
  std::string time;    ///< "2026-11-22 21:50:07", where the person was
  std::string folder;  ///< the working directory; names of files are meant from there
  std::string from;    ///< the scene or the script that it began with; "" for none
};

/// A journal begins with its head; each deed comes behind the last. A part that is not whole counts
/// for nothing: whatever of a journal has reached the disk, its beginning can be read.
std::string journal_text(const JournalHead& head);
std::string journal_text(const Deed& deed);

struct Journal {
  struct Entry {
    Deed deed;
    std::size_t line = 0;  ///< of its command in the file, from 1
  };
  JournalHead head;
  std::vector<Entry> entries;
  std::size_t whole = 0;  ///< bytes up to the end of the last entry that is whole
};

/// Throws FileError where there is no whole head, or one of another version.
Journal read_journal(const std::string& name, std::string_view text);

}  // namespace sir::modeler
