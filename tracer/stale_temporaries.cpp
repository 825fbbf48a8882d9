#include "tracer/stale_temporaries.h"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <string>

namespace sir {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = ".sir-", kEnd = ".tmp";
constexpr long kXfsMagic = 0x58465342;  // linux/magic.h lacks it
// Far longer than any writing takes; a person who looks at the folder the next day finds it clean.
constexpr time_t kNetworkPatience = 3600;

// Removes a number from the front of `text`.
bool take_number(std::string_view& text) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  text.remove_prefix(digits);
  return digits > 0;
}

// Whether all who may use these files share this kernel, and with it the locks.
bool is_local(int descriptor) {
  constexpr std::array<long, 6> kLocal{EXT4_SUPER_MAGIC, BTRFS_SUPER_MAGIC, F2FS_SUPER_MAGIC,
                                       TMPFS_MAGIC,      kXfsMagic,         OVERLAYFS_SUPER_MAGIC};
  struct statfs system {};
  return ::fstatfs(descriptor, &system) == 0 &&
         std::find(kLocal.begin(), kLocal.end(), static_cast<long>(system.f_type)) != kLocal.end();
}

bool is_stale(int descriptor, int newest, bool local) {
  struct stat file {
  }, mine{};
  if (::fstat(descriptor, &file) != 0 || ::fstat(newest, &mine) != 0) return false;
  if (!S_ISREG(file.st_mode) || file.st_uid != ::geteuid()) return false;
  if (!local && mine.st_mtime - file.st_mtime < kNetworkPatience) return false;
  return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

}  // namespace

fs::path temporary_beside(const fs::path& destination) {
  static std::atomic<unsigned> serial{0};
  return fs::path(destination) += std::string(kMark) + std::to_string(::getpid()) + "-" +
                                  std::to_string(serial++) + std::string(kEnd);
}

bool is_temporary_of(std::string_view name, std::string_view destination) {
  const auto take = [&](std::string_view part) {
    if (!name.starts_with(part)) return false;
    name.remove_prefix(part.size());
    return true;
  };
  return take(destination) && take(kMark) && take_number(name) && take("-") && take_number(name) &&
         name == kEnd;
}

bool mark_as_written(int descriptor) {
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
  // Whoever removes a file holds its lock meanwhile: it is gone by now, or will not go.
  struct stat file {};
  return ::fstat(descriptor, &file) != 0 || file.st_nlink > 0;
}

void remove_stale_temporaries(const fs::path& destination, int newest) noexcept {
  try {
    const std::string name = destination.filename();
    const bool local = is_local(newest);
    const fs::path folder = destination.has_parent_path() ? destination.parent_path() : ".";
    std::error_code failure;
    for (fs::directory_iterator at(folder, failure), end; !failure && at != end;
         at.increment(failure)) {
      if (!is_temporary_of(at->path().filename().native(), name)) continue;
      // For writing: NFS gives no other descriptor an exclusive lock.
      const int descriptor =
          ::open(at->path().c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
      if (descriptor < 0) continue;
      if (is_stale(descriptor, newest, local)) ::unlink(at->path().c_str());
      ::close(descriptor);
    }
  } catch (const std::exception&) {  // no memory: what is left over does no harm
  }
}

}  // namespace sir
