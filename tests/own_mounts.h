// A small disk, a disk that is read-only: in a process of its own, so that nobody else sees them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace sir::test {

/// What became of the work.
struct Elsewhere {
  bool possible = false;  ///< whether this machine permits it
  std::string why_not;
  bool passed = false;  ///< no expectation failed; what failed has been printed
};

/// Runs `work`, which may mount on `folder` and expect, in a child that has mounts of its own: as
/// root there or in a user namespace, where the kernel permits either.
Elsewhere with_own_mounts(const std::filesystem::path& folder, const std::function<void()>& work);

/// Runs `work` in a child where the permissions of files hold, for root too.
Elsewhere without_privileges(const std::function<void()>& work);

/// For with_own_mounts(): an empty tmpfs of so many pages of 4096 bytes on `folder`.
bool mount_small_disk(const std::filesystem::path& folder, int pages);

/// Makes it read-only.
bool make_read_only(const std::filesystem::path& folder);

void unmount(const std::filesystem::path& folder);

/// Fills what is free but for `pages`, with the file `name`. Returns whether it did.
bool fill_disk(const std::filesystem::path& folder, const std::string& name, int pages);

}  // namespace sir::test
