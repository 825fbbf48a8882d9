// Keeps a person's session in a journal while it goes on, and brings back one that was not ended.
// The thesis's modeler forgets (3.2).
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "modeler/interpreter.h"
#include "modeler/journal_file.h"
#include "modeler/kept_sessions.h"

namespace sir::modeler {

/// Writes each command of an interpreter that changed something behind the others, at once. The
/// journal is made with the first of them. Where it cannot be, or no longer, that is said once, and
/// the session goes on. For the interpreter's thread; the interpreter outlives it.
class Keeper {
 public:
  /// `folder` is where journals are; empty: there is no such place. `from`: what is opened or run
  /// before a person does anything, which is from begin() on; "" for nothing.
  Keeper(Interpreter& interpreter, std::filesystem::path folder, std::string from = {});

  /// The session is dropped, as by a signal: its journal stays where it has something of the
  /// person's.
  ~Keeper();
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;

  /// From here on it is a person that gives the commands. What came before is made again by whoever
  /// begins so again, and is by itself no reason to keep a journal.
  void begin() {
    begun_ = true;
    own_ = recovered_;
  }

  /// Whether what there is goes on from another session.
  bool recovered() const { return recovered_; }

  /// Those that `recover` can bring back, the last one first.
  std::vector<KeptSession> sessions() const { return kept_sessions(folder_); }

  /// A line that tells of them; "" where there are none.
  std::string offer() const;

  /// The session was ended as it should be: its journal goes where all is saved, or nothing was
  /// done. Else it stays; returns a line that says so.
  std::string end();

 private:
  std::string note(const Deed& deed);
  Reply recover(const std::vector<std::string>& words);
  Reply list() const;
  Reply discard(const std::string& which) const;
  Reply bring_back(const std::filesystem::path& file);
  std::filesystem::path last() const;
  std::string put_aside(const Interpreter& session);

  Interpreter& interpreter_;
  std::filesystem::path folder_;
  std::string from_;
  std::unique_ptr<JournalFile> journal_;
  bool broken_ = false;  // nothing more can be written
  bool own_ = false;     // a person has changed something
  bool recovered_ = false;
  bool begun_;  // what is done is done by a person
};

}  // namespace sir::modeler
