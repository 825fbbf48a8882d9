#include "modeler/keeper.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "modeler/command_error.h"
#include "modeler/command_line.h"
#include "modeler/playback.h"
#include "tracer/error.h"

namespace sir::modeler {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTold = 10;  // commands that were refused, one by one

// Whether who did this would miss it. A view is soon found again, and what is in a file is there.
bool is_work(const std::string& command) {
  const std::vector<std::string> words = split_words(command);
  const CommandInfo* info = words.empty() ? nullptr : find_command(words.front());
  if (info == nullptr) return true;
  switch (info->command) {
    case Command::camera:
    case Command::view:
    case Command::select:
    case Command::show:
    case Command::save:
    case Command::forget: return false;
    default: return true;
  }
}

std::string working_folder() {
  std::error_code failure;
  const fs::path folder = fs::current_path(failure);
  return failure ? "" : folder.string();
}

// Stands in a journal where some of the commands before it could not be done: what is undone behind
// it is what there was then.
Deed not_all_of(const Interpreter& interpreter) {
  Deed deed;
  deed.command = "# recovered, not all of it";
  deed.undoable = interpreter.undoable();
  return deed;
}

std::string shown_name(const fs::path& file) { return file.stem().string(); }

}  // namespace

Keeper::Keeper(Interpreter& interpreter, fs::path folder, std::string from)
    : interpreter_(interpreter),
      folder_(std::move(folder)),
      from_(std::move(from)),
      begun_(from_.empty()) {
  interpreter_.keep({[this](const Deed& deed) { return note(deed); },
                     [this](const std::vector<std::string>& words) { return recover(words); },
                     [this] { return kept_names(folder_); }});
}

Keeper::~Keeper() {
  interpreter_.keep({});
  if (journal_ && !own_) journal_->remove();
}

std::string Keeper::note(const Deed& deed) {
  own_ = own_ || (begun_ && is_work(deed.command));
  if (broken_) return {};
  try {
    if (!journal_) {
      if (folder_.empty())
        throw FileError("HOME", 0, "there is none, nor XDG_STATE_HOME, for a journal");
      journal_ = new_journal(folder_, {time_now(), working_folder(), from_});
    }
    journal_->append(journal_text(deed));
    return {};
  } catch (const FileError& error) {
    broken_ = true;
    return std::string(error.what()) +
           "; from here on nothing of this session could be recovered after a crash";
  }
}

std::string Keeper::offer() const {
  const std::vector<KeptSession> kept = sessions();
  if (kept.empty()) return {};
  return fmt::format(
      "{} can be recovered; the last: {}. recover does it; recover --list, --discard",
      counted(kept.size(), "session"), text_of(kept.front()));
}

std::string Keeper::put_aside(const Interpreter& session) {
  const std::unique_ptr<JournalFile> journal = std::move(journal_);
  broken_ = false;
  const bool saved = session.unsaved().empty() && !session.looks_unsaved();
  if (!journal) return {};
  if (saved || !std::exchange(own_, false)) {
    journal->remove();
    return {};
  }
  return fmt::format("not all was saved; {} is kept: sir model, then recover",
                     shown_name(journal->path()));
}

std::string Keeper::end() { return put_aside(interpreter_); }

Reply Keeper::recover(const std::vector<std::string>& words) {
  const auto second = [&] { return words.size() > 1 ? words[1] : std::string(); };
  if (words.empty()) return bring_back(last());
  if (is_word(words[0], "--list", "--lista")) return list();
  if (is_word(words[0], "--discard", "--descarta")) return discard(second());
  if (words[0].starts_with("--"))
    throw CommandError(in_quotes(words[0]) + " is no option of recover: --list, --discard");
  return bring_back(kept_file(folder_, words[0]));
}

fs::path Keeper::last() const {
  const std::vector<std::string> names = kept_names(folder_);
  if (names.empty()) throw CommandError("there is no session to recover");
  return kept_file(folder_, names.front());
}

Reply Keeper::list() const {
  Reply reply;
  for (const KeptSession& session : sessions()) {
    reply.text += session.name + ": " + text_of(session) + "\n";
    for (const std::string& file : session.changed)
      reply.text += "  changed since: " + visible(file) + "\n";
  }
  if (reply.text.empty()) reply.text = "there is no session to recover\n";
  return reply;
}

Reply Keeper::discard(const std::string& which) const {
  std::vector<fs::path> files;
  if (is_word(which, "all", "todas"))
    for (const std::string& name : kept_names(folder_)) files.push_back(kept_file(folder_, name));
  else files.push_back(which.empty() ? last() : kept_file(folder_, which));
  std::string done;
  for (const fs::path& file : files) {
    auto locked = LockedFile::open(file, Hold::to_have);
    if (!locked)
      throw CommandError(in_quotes(shown_name(file)) + " is not there, or still goes on");
    read_journal(file.filename().string(), locked->text());  // no other file is removed
    locked->remove();
    done += (done.empty() ? "discarded: " : ", ") + shown_name(file);
  }
  return {{}, done.empty() ? "there is no session to discard" : done, {}, false};
}

Reply Keeper::bring_back(const fs::path& file) {
  auto locked = LockedFile::open(file, Hold::to_have);
  if (!locked) throw CommandError(in_quotes(shown_name(file)) + " is not there, or still goes on");
  const std::string name = file.filename().string();
  const std::string text = locked->text();
  const Journal journal = read_journal(name, text);
  Reply reply;
  for (const std::string& changed : changed_files(journal))
    reply.text += visible(changed) + ": has changed since; taken as it was read then\n";
  if (journal.head.folder != working_folder())
    reply.text += "the session worked in " + visible(journal.head.folder) +
                  ": names of files are meant from there\n";
  Interpreter before = interpreter_;
  Playback played;
  interpreter_.clear();
  try {
    played = play_back(name, journal, interpreter_);
  } catch (...) {
    interpreter_ = std::move(before);
    throw;
  }
  std::string aside = put_aside(before);
  for (std::size_t i = 0; i < played.failed.size() && i < kTold; ++i)
    reply.warnings.push_back(played.failed[i]);
  if (played.failed.size() > kTold)
    reply.warnings.push_back(
        fmt::format("and {} more that could not be done", played.failed.size() - kTold));
  if (journal.whole < text.size())
    reply.warnings.push_back(fmt::format("{}: its last {} are no whole command and are left out",
                                         name, counted(text.size() - journal.whole, "byte")));
  if (!aside.empty()) reply.warnings.push_back(std::move(aside));
  own_ = recovered_ = true;
  try {
    journal_ = std::make_unique<JournalFile>(std::move(*locked), journal.whole);
    if (!played.failed.empty()) journal_->append(journal_text(not_all_of(interpreter_)));
  } catch (const FileError& error) {
    broken_ = true;
    reply.warnings.push_back(std::string(error.what()) +
                             "; what is done from here on could not be recovered after a crash");
  }
  reply.done =
      fmt::format("recovered: {} of {}", counted(played.done, "command"), journal.head.time);
  return reply;
}

}  // namespace sir::modeler
