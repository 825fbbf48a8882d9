#include "tracer/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>

#include "tracer/error.h"
#include "tracer/stale_temporaries.h"

namespace sir {
namespace {

std::string reason_of(int code) { return std::strerror(code); }

// Names of the temporary files there are, for remove_temporaries(). More files
// than that are not open at once.
std::array<std::atomic<const char*>, 16> temporaries;

void remember(const char* name) {
  for (auto& slot : temporaries)
    if (const char* empty = nullptr; slot.compare_exchange_strong(empty, name)) return;
}

void forget(const char* name) {
  for (auto& slot : temporaries)
    if (const char* same = name; slot.compare_exchange_strong(same, nullptr)) return;
}

// What a chain of symbolic links leads to, be it there or not. Links to pipes and
// devices stay: those of /dev/stdout's kind need not lead to a name.
std::filesystem::path followed(std::filesystem::path path) {
  constexpr int kMostLinks = 40;  // as in the kernel
  std::error_code failure;
  if (const auto status = std::filesystem::status(path, failure);
      std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    return path;
  for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(path, failure); ++i) {
    auto target = std::filesystem::read_symlink(path, failure);
    if (failure) break;
    path = path.parent_path() / target;
  }
  return path;
}

// Of an output: whether it is written directly. Throws where it cannot be written.
bool is_written_directly(const std::filesystem::path& destination) {
  std::error_code failure;
  const auto status = std::filesystem::status(destination, failure);
  if (status.type() == std::filesystem::file_type::none)
    throw FileError(destination.string(), 0, "cannot be written: " + failure.message());
  if (!std::filesystem::exists(status)) return false;
  // A rename would replace a file that is protected against writing.
  if (::faccessat(AT_FDCWD, destination.c_str(), W_OK, AT_EACCESS) != 0)
    throw FileError(destination.string(), 0, "cannot be written: " + reason_of(errno));
  return !std::filesystem::is_regular_file(status);
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path destination, mode_t mode)
    // A symbolic link keeps pointing where it points: its target is replaced.
    : destination_(followed(std::move(destination))), direct_(is_written_directly(destination_)) {
  if (direct_) descriptor_ = ::open(destination_.c_str(), O_WRONLY | O_CLOEXEC);
  else make_temporary(mode);
  if (descriptor_ < 0) fail(errno);
  if (direct_) return;
  remember(temporary_.c_str());
  // The permissions of a file that is replaced are kept.
  struct stat old {};
  if (::stat(destination_.c_str(), &old) == 0) (void)!::fchmod(descriptor_, old.st_mode & 07777);
  remove_stale_temporaries(destination_, descriptor_);
}

AtomicFile::~AtomicFile() {
  if (!temporary_.empty()) {
    ::unlink(temporary_.c_str());
    forget(temporary_.c_str());
  }
  if (descriptor_ >= 0) ::close(descriptor_);
}

void AtomicFile::fail(int code) const {
  throw FileError(destination_.string(), 0, "cannot be written: " + reason_of(code));
}

// Another name where one is taken, left over by a process that had our number.
void AtomicFile::make_temporary(mode_t mode) {
  for (;;) {
    temporary_ = temporary_beside(destination_);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (descriptor_ < 0) {
      if (errno == EEXIST) continue;
      temporary_.clear();
      return;
    }
    if (mark_as_written(descriptor_)) return;
    ::close(descriptor_);
  }
}

void AtomicFile::write(std::span<const std::byte> bytes) {
  flushed_ = false;
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      fail(errno);
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void AtomicFile::write(std::string_view text) {
  write(std::as_bytes(std::span(text.data(), text.size())));
}

void AtomicFile::flush() {
  if (!flushed_ && !direct_ && ::fsync(descriptor_) != 0) fail(errno);
  flushed_ = true;
}

// The descriptor, and with it the lock, lasts until the name is taken. After fsync its close has
// nothing more to tell.
void AtomicFile::take_name() {
  if (!direct_) {
    if (::rename(temporary_.c_str(), destination_.c_str()) != 0) fail(errno);
    forget(temporary_.c_str());
    temporary_.clear();
  }
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0 && direct_) fail(errno);
}

int sync_folder_of(const std::filesystem::path& file) {
  const auto folder = file.has_parent_path() ? file.parent_path() : ".";
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return 0;  // a folder may be written that may not be read
  const int code = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  // EINVAL: a file system that does this for files alone.
  return code == EINVAL || code == ENOTSUP ? 0 : code;
}

void AtomicFile::sync_folder() const {
  if (direct_) return;
  if (const int code = sync_folder_of(destination_); code != 0) fail(code);
}

void AtomicFile::commit() {
  flush();
  take_name();
  sync_folder();
}

// Without looking for what is left over: large folders are searched once for an output, not twice.
void require_writable(const std::filesystem::path& destination) {
  const auto path = followed(destination);
  int code = 0;
  if (is_written_directly(path)) {
    code = std::filesystem::is_directory(path) ? EISDIR : 0;
  } else {
    const auto trial = temporary_beside(path);
    const int descriptor = ::open(trial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (descriptor < 0) {
      code = errno;
    } else {
      ::unlink(trial.c_str());
      ::close(descriptor);
    }
  }
  if (code != 0 && code != EEXIST)
    throw FileError(path.string(), 0, "cannot be written: " + reason_of(code));
}

void remove_temporaries() noexcept {
  for (const auto& slot : temporaries)
    if (const char* name = slot.load()) ::unlink(name);
}

void write_file_atomically(const std::filesystem::path& destination,
                           std::span<const std::byte> bytes) {
  AtomicFile file(destination);
  file.write(bytes);
  file.commit();
}

void write_file_atomically(const std::filesystem::path& destination, std::string_view text) {
  write_file_atomically(destination, std::as_bytes(std::span(text.data(), text.size())));
}

void refuse_same_file(const std::filesystem::path& output, const std::filesystem::path& input) {
  std::error_code missing;
  if (std::filesystem::equivalent(output, input, missing))
    throw FileError(output.string(), 0, "is an input and is not overwritten");
}

}  // namespace sir
