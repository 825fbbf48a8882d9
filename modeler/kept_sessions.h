// Sessions that were not ended, or ended with something not saved (the thesis has none).
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "modeler/journal_file.h"
#include "modeler/journal_text.h"

namespace sir::modeler {

/// So many journals are kept; where there are more the oldest go.
inline constexpr std::size_t kMostKept = 20;

/// A journal that nobody works on.
struct KeptSession {
  std::string name;  ///< what `recover` takes: the file's name without its suffix
  std::filesystem::path file;
  JournalHead head;
  std::string last;  ///< when its last command was given, as head.time
  std::size_t commands = 0;
  std::vector<std::string> changed;  ///< files that it read and that are not as they were then
  std::string trouble;               ///< why it cannot be read; "" where it can
};

/// Those of a folder, the last one first. A folder that is not there has none.
std::vector<KeptSession> kept_sessions(const std::filesystem::path& folder);

/// Their names alone, in the same order: the journals are not read.
std::vector<std::string> kept_names(const std::filesystem::path& folder);

/// The file that a person means: a name, with or without its suffix, or a path.
std::filesystem::path kept_file(const std::filesystem::path& folder, const std::string& given);

/// "calice in /home/who, 2026-11-22 21:50:07, 14 commands"
std::string text_of(const KeptSession& session);

/// A new journal, which has its head before it has a name that kept_sessions() knows. The oldest go
/// where there are too many. Throws FileError.
std::unique_ptr<JournalFile> new_journal(const std::filesystem::path& folder,
                                         const JournalHead& head);

/// Files that have been read by a session and are not as they were then, each once.
std::vector<std::string> changed_files(const Journal& journal);

/// This moment as JournalHead has it.
std::string time_now();

}  // namespace sir::modeler
