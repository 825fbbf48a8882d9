#include "modeler/journal_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "tracer/all_signals_held.h"
#include "tracer/atomic_file.h"
#include "tracer/error.h"

namespace sir::modeler {
namespace {

using Path = std::filesystem::path;

[[noreturn]] void fail(const Path& path, const char* what) {
  throw FileError(path.string(), 0, std::string(what) + ": " + std::strerror(errno));
}

}  // namespace

LockedFile::LockedFile(Path path, int descriptor)
    : path_(std::move(path)), descriptor_(descriptor) {}

LockedFile::LockedFile(LockedFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

LockedFile::~LockedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

LockedFile LockedFile::create(const Path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0) fail(path, "cannot be written");
  LockedFile file(path, descriptor);
  // Where there are no locks it is kept all the same; only that it is not offered back by itself.
  (void)::flock(descriptor, LOCK_EX | LOCK_NB);
  return file;
}

std::optional<LockedFile> LockedFile::open(const Path& path, Hold hold) {
  constexpr int kFlags = O_CLOEXEC | O_NONBLOCK | O_NOCTTY;
  int descriptor = ::open(path.c_str(), O_RDWR | kFlags);
  if (descriptor < 0 && errno != ENOENT) descriptor = ::open(path.c_str(), O_RDONLY | kFlags);
  if (descriptor < 0 && errno == ENOENT) return std::nullopt;
  if (descriptor < 0) fail(path, "cannot be read");
  LockedFile file(path, descriptor);
  // Others look at it for a moment only.
  constexpr int kTries = 100;
  constexpr std::chrono::milliseconds kMoment{10};
  const int tries = hold == Hold::to_have ? kTries : 1;
  const int lock = (hold == Hold::to_have ? LOCK_EX : LOCK_SH) | LOCK_NB;
  for (int i = 0; ::flock(descriptor, lock) != 0; std::this_thread::sleep_for(kMoment))
    if (++i == tries) return std::nullopt;
  struct stat about {};
  // Who had it before us may have removed it.
  if (::fstat(descriptor, &about) != 0 || about.st_nlink == 0) return std::nullopt;
  if (!S_ISREG(about.st_mode)) throw FileError(path.string(), 0, "cannot be read: it is no file");
  return file;
}

std::string LockedFile::text() const {
  std::string text;
  std::array<char, 1 << 16> chunk;
  for (;;) {
    const ssize_t got =
        ::pread(descriptor_, chunk.data(), chunk.size(), static_cast<off_t>(text.size()));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path_, "cannot be read");
    if (got == 0) return text;
    text.append(chunk.data(), static_cast<std::size_t>(got));
  }
}

void LockedFile::take_name(const Path& path) {
  if (::rename(path_.c_str(), path.c_str()) != 0) fail(path, "cannot be written");
  path_ = path;
}

void LockedFile::remove() noexcept { ::unlink(path_.c_str()); }

JournalFile::JournalFile(LockedFile file, std::size_t whole)
    : file_(std::move(file)), size_(whole) {
  if (::ftruncate(file_.descriptor(), static_cast<off_t>(whole)) != 0)
    fail(file_.path(), "cannot be written");
  const AllSignalsHeld held;  // the new thread gets none: they are for the one that reads
  syncer_ = std::jthread([this](const std::stop_token& stop) { keep_synced(stop); });
}

JournalFile::~JournalFile() {
  syncer_.request_stop();
  syncer_.join();
  if (unsynced_) ::fdatasync(file_.descriptor());
}

void JournalFile::take_name(const Path& path) {
  const std::lock_guard lock(mutex_);
  file_.take_name(path);
}

void JournalFile::append(std::string_view text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t put = ::pwrite(file_.descriptor(), text.data() + written, text.size() - written,
                                 static_cast<off_t>(size_ + written));
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) {
      const int reason = errno;
      (void)!::ftruncate(file_.descriptor(), static_cast<off_t>(size_));
      errno = reason;
      fail(file_.path(), "cannot be written");
    }
    written += static_cast<std::size_t>(put);
  }
  size_ += text.size();
  const std::lock_guard lock(mutex_);
  if (!std::exchange(unsynced_, true)) grown_.notify_one();
}

void JournalFile::keep_synced(const std::stop_token& stop) {
  bool named = false;
  std::unique_lock lock(mutex_);
  while (grown_.wait(lock, stop, [this] { return unsynced_; })) {
    // What comes in the meantime goes with it.
    grown_.wait_for(lock, stop, kSyncedAfter, [] { return false; });
    if (stop.stop_requested()) return;
    unsynced_ = false;
    const Path path = file_.path();
    lock.unlock();
    ::fdatasync(file_.descriptor());
    if (!std::exchange(named, true)) (void)sync_folder_of(path);
    lock.lock();
  }
}

}  // namespace sir::modeler
