#include "tests/own_mounts.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/statvfs.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

namespace sir::test {
namespace {

constexpr int kPassed = 0, kFailed = 1, kImpossible = 2;
constexpr std::size_t kPage = 4096;

bool put(const char* file, const std::string& text) {
  return bool(std::ofstream(file) << text << std::flush);
}

bool unshare_mounts() {
  const auto user = std::to_string(::geteuid()), group = std::to_string(::getegid());
  if (::unshare(CLONE_NEWNS) != 0) {
    if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
    put("/proc/self/setgroups", "deny");
    if (!put("/proc/self/uid_map", "0 " + user + " 1") ||
        !put("/proc/self/gid_map", "0 " + group + " 1"))
      return false;
  }
  return ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
}

Elsewhere in_child(const std::function<bool()>& prepare, const std::function<void()>& work) {
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child < 0) return {false, "no process", false};
  if (child == 0) {
    if (!prepare()) ::_exit(kImpossible);
    try {
      work();
    } catch (const std::exception& failure) {
      ADD_FAILURE() << failure.what();
    }
    std::fflush(nullptr);
    ::_exit(testing::Test::HasFailure() ? kFailed : kPassed);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : kFailed;
  return {code != kImpossible, code == kImpossible ? "not permitted here" : "", code == kPassed};
}

}  // namespace

Elsewhere with_own_mounts(const std::filesystem::path& folder, const std::function<void()>& work) {
  // A container may permit the namespace and not the mount.
  const auto prepare = [&] {
    if (!unshare_mounts() || !mount_small_disk(folder, 1)) return false;
    unmount(folder);
    return true;
  };
  return in_child(prepare, work);
}

Elsewhere without_privileges(const std::function<void()>& work) {
  // What is not in the bounding set, no program that is started has.
  const auto prepare = [] {
    return ::geteuid() != 0 || (::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0) == 0 &&
                                ::prctl(PR_CAPBSET_DROP, CAP_DAC_READ_SEARCH, 0, 0, 0) == 0);
  };
  return in_child(prepare, work);
}

bool mount_small_disk(const std::filesystem::path& folder, int pages) {
  const std::string options = "size=" + std::to_string(static_cast<std::size_t>(pages) * kPage);
  return ::mount("none", folder.c_str(), "tmpfs", 0, options.c_str()) == 0;
}

bool make_read_only(const std::filesystem::path& folder) {
  return ::mount("none", folder.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr) == 0;
}

void unmount(const std::filesystem::path& folder) { ::umount(folder.c_str()); }

bool fill_disk(const std::filesystem::path& folder, const std::string& name, int pages) {
  struct statvfs disk {};
  if (::statvfs(folder.c_str(), &disk) != 0) return false;
  const std::size_t free = disk.f_bavail * disk.f_frsize / kPage;
  if (free < static_cast<std::size_t>(pages)) return false;
  const std::string bytes((free - static_cast<std::size_t>(pages)) * kPage, 'x');
  return bool(std::ofstream(folder / name, std::ios::binary) << bytes << std::flush);
}

}  // namespace sir::test
