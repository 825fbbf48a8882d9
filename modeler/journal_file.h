// A journal on the disk (the thesis has none).
#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

namespace sir::modeler {

/// What for a file is locked: many may look at one that nobody has.
enum class Hold { to_look, to_have };

/// An open file that nobody else has: locked (flock) until it is closed, by the end of the process
/// at the latest, however it ends. What is not locked belongs to nobody who is alive, whatever
/// process has its number now.
class LockedFile {
 public:
  /// Creates it with mode 0600; it must not be there. Throws FileError.
  static LockedFile create(const std::filesystem::path& path);

  /// One that is there; none where it is another's, or gone. Throws FileError where it cannot be
  /// read.
  static std::optional<LockedFile> open(const std::filesystem::path& path, Hold hold);

  LockedFile(LockedFile&& other) noexcept;
  LockedFile& operator=(LockedFile&&) = delete;
  ~LockedFile();

  const std::filesystem::path& path() const { return path_; }
  int descriptor() const { return descriptor_; }

  std::string text() const;                           ///< all of it. Throws FileError
  void take_name(const std::filesystem::path& path);  ///< another one. Throws FileError
  void remove() noexcept;

 private:
  LockedFile(std::filesystem::path path, int descriptor);

  std::filesystem::path path_;
  int descriptor_;
};

/// Grows at its end. What append() was given is the kernel's when it returns: the end of the
/// process takes nothing from it. Within kSyncedAfter, and the time that the disk takes, it is on
/// the disk too; another thread sees to that, so nobody waits for it.
class JournalFile {
 public:
  static constexpr std::chrono::seconds kSyncedAfter{2};

  /// Goes on behind the first `whole` bytes; the others go. Throws FileError.
  JournalFile(LockedFile file, std::size_t whole);
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  /// Throws FileError where not all of it could be written; then nothing of it is there.
  void append(std::string_view text);

  const std::filesystem::path& path() const { return file_.path(); }
  void take_name(const std::filesystem::path& path);
  void remove() noexcept { file_.remove(); }

 private:
  void keep_synced(const std::stop_token& stop);

  LockedFile file_;
  std::size_t size_;
  std::mutex mutex_;
  std::condition_variable_any grown_;
  bool unsynced_ = true;
  std::jthread syncer_;  // the last member: it uses the others
};

}  // namespace sir::modeler
