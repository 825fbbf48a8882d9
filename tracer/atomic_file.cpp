#include "tracer/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>

#include "tracer/error.h"

namespace sir {
namespace {

std::string reason_of(int code) { return std::strerror(code); }

// Unique within the process; the process number keeps processes apart.
std::filesystem::path temporary_beside(const std::filesystem::path& destination) {
  static std::atomic<unsigned> serial{0};
  return std::filesystem::path(destination) +=
         "." + std::to_string(::getpid()) + "-" + std::to_string(serial++) + ".tmp";
}

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

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path destination)
    // A symbolic link keeps pointing where it points: its target is replaced.
    : destination_(followed(std::move(destination))) {
  std::error_code failure;
  const auto status = std::filesystem::status(destination_, failure);
  if (status.type() == std::filesystem::file_type::none)
    throw FileError(destination_.string(), 0, "cannot be written: " + failure.message());
  const bool exists = std::filesystem::exists(status);
  // A rename would replace a file that is protected against writing.
  if (exists && ::faccessat(AT_FDCWD, destination_.c_str(), W_OK, AT_EACCESS) != 0)
    throw FileError(destination_.string(), 0, "cannot be written: " + reason_of(errno));
  const bool direct = exists && !std::filesystem::is_regular_file(status);
  if (direct) {
    descriptor_ = ::open(destination_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    temporary_ = temporary_beside(destination_);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  }
  if (descriptor_ < 0)
    throw FileError(destination_.string(), 0, "cannot be written: " + reason_of(errno));
  if (!direct) remember(temporary_.c_str());
  // The permissions of a file that is replaced are kept.
  struct stat old {};
  if (!direct && ::stat(destination_.c_str(), &old) == 0)
    (void)!::fchmod(descriptor_, old.st_mode & 07777);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (temporary_.empty()) return;
  ::unlink(temporary_.c_str());
  forget(temporary_.c_str());
}

void AtomicFile::write(std::span<const std::byte> bytes) {
  flushed_ = false;
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      throw FileError(destination_.string(), 0, "cannot be written: " + reason_of(errno));
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void AtomicFile::write(std::string_view text) {
  write(std::as_bytes(std::span(text.data(), text.size())));
}

void AtomicFile::flush() {
  if (!flushed_ && !temporary_.empty() && ::fsync(descriptor_) != 0)
    throw FileError(destination_.string(), 0, "cannot be written: " + reason_of(errno));
  flushed_ = true;
}

void AtomicFile::commit() {
  flush();
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0)
    throw FileError(destination_.string(), 0, "cannot be written: " + reason_of(errno));
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), destination_.c_str()) != 0)
    throw FileError(destination_.string(), 0, "cannot be written: " + reason_of(errno));
  forget(temporary_.c_str());
  temporary_.clear();
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
