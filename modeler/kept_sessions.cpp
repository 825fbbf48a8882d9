#include "modeler/kept_sessions.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <ctime>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "modeler/state_folder.h"
#include "tracer/error.h"
#include "tracer/text_file.h"

namespace sir::modeler {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSuffix = ".journal";
constexpr const char* kUnfinished = ".new";  // in the making

std::string text_of(std::time_t time, const char* form) {
  std::tm parts{};
  ::localtime_r(&time, &parts);
  char text[32];
  return {text, std::strftime(text, sizeof text, form, &parts)};
}

constexpr const char* kTime = "%Y-%m-%d %H:%M:%S";

struct Found {
  timespec time;
  fs::path file;
};

// Whether of two that were written to in the same moment or not, this is to come first.
bool is_later(const Found& a, const Found& b) {
  if (a.time.tv_sec != b.time.tv_sec) return a.time.tv_sec > b.time.tv_sec;
  if (a.time.tv_nsec != b.time.tv_nsec) return a.time.tv_nsec > b.time.tv_nsec;
  return a.file > b.file;
}

// The files with this suffix, the last one first, whoever works on them.
std::vector<Found> files_in(const fs::path& folder, const char* suffix) {
  std::vector<Found> found;
  if (folder.empty()) return found;
  std::error_code failure;
  for (fs::directory_iterator at(folder, failure), end; !failure && at != end;
       at.increment(failure)) {
    struct stat about {};
    if (at->path().extension() == suffix && ::stat(at->path().c_str(), &about) == 0 &&
        S_ISREG(about.st_mode))
      found.push_back({about.st_mtim, at->path()});
  }
  std::sort(found.begin(), found.end(), is_later);
  return found;
}

bool is_abandoned(const fs::path& file) {
  try {
    return LockedFile::open(file, Hold::to_look).has_value();
  } catch (const FileError&) {
    return false;
  }
}

void remove_if_abandoned(const fs::path& file) {
  try {
    if (auto locked = LockedFile::open(file, Hold::to_have)) locked->remove();
  } catch (const FileError&) {
    // It is another's.
  }
}

void tidy(const fs::path& folder) {
  std::size_t kept = 0;
  for (const Found& found : files_in(folder, kSuffix))
    if (is_abandoned(found.file) && ++kept > kMostKept) remove_if_abandoned(found.file);
  // Whoever makes one needs a moment for it, and none that is not locked after an hour.
  constexpr std::time_t kAMoment = 3600;
  for (const Found& found : files_in(folder, kUnfinished))
    if (found.time.tv_sec < std::time(nullptr) - kAMoment) remove_if_abandoned(found.file);
}

bool is_as_it_was(const TextRead& read) {
  try {
    return TextFile(fs::path(read.file)).whole() == read.text;
  } catch (const FileError&) {
    return false;
  }
}

}  // namespace

std::string time_now() { return text_of(std::time(nullptr), kTime); }

std::vector<std::string> changed_files(const Journal& journal) {
  // What was read last is what the file should still be.
  std::map<std::string, const TextRead*> last;
  for (const Journal::Entry& entry : journal.entries)
    for (const TextRead& read : entry.deed.files)
      last[(fs::path(journal.head.folder) / read.file).lexically_normal().string()] = &read;
  std::vector<std::string> changed;
  for (const auto& [file, read] : last)
    if (!is_as_it_was({file, read->text})) changed.push_back(file);
  return changed;
}

std::vector<KeptSession> kept_sessions(const fs::path& folder) {
  std::vector<KeptSession> sessions;
  for (const Found& found : files_in(folder, kSuffix)) {
    KeptSession session;
    session.name = found.file.stem().string();
    session.file = found.file;
    session.last = text_of(found.time.tv_sec, kTime);
    try {
      const auto locked = LockedFile::open(found.file, Hold::to_look);
      if (!locked) continue;
      const Journal journal = read_journal(found.file.filename().string(), locked->text());
      session.head = journal.head;
      session.commands = journal.entries.size();
      session.changed = changed_files(journal);
    } catch (const FileError& error) {
      session.trouble = error.what();
    }
    sessions.push_back(std::move(session));
  }
  return sessions;
}

std::vector<std::string> kept_names(const fs::path& folder) {
  std::vector<std::string> names;
  for (const Found& found : files_in(folder, kSuffix))
    if (is_abandoned(found.file)) names.push_back(found.file.stem().string());
  return names;
}

fs::path kept_file(const fs::path& folder, const std::string& given) {
  if (given.find('/') != given.npos) return given;
  const fs::path file = folder / given;
  return file.extension() == kSuffix ? file : fs::path(file.string() + kSuffix);
}

std::string text_of(const KeptSession& session) {
  if (!session.trouble.empty()) return session.trouble;
  const JournalHead& head = session.head;
  return visible(fmt::format("{}{}, {}, {}", head.from.empty() ? "" : head.from + " ",
                             "in " + head.folder, session.last,
                             counted(session.commands, "command")));
}

std::unique_ptr<JournalFile> new_journal(const fs::path& folder, const JournalHead& head) {
  make_state_folder(folder);
  tidy(folder);
  static std::atomic<unsigned> serial{0};
  const unsigned number = serial++;
  std::string name =
      fmt::format("session-{}-{}", text_of(std::time(nullptr), "%Y%m%d-%H%M%S"), ::getpid());
  if (number > 0) name += "-" + std::to_string(number);
  auto file = std::make_unique<JournalFile>(LockedFile::create(folder / (name + kUnfinished)), 0);
  try {
    file->append(journal_text(head));
    file->take_name(folder / (name + kSuffix));
  } catch (const FileError&) {
    file->remove();
    throw;
  }
  return file;
}

}  // namespace sir::modeler
