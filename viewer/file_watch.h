// Notices changes of files, and waits until a change has come to rest. The thesis's programs end
// before their files change.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace sir::viewer {

/// A file as it was found. Missing ones are all alike.
struct FileStamp {
  std::filesystem::path file;
  bool there = false;
  std::uint64_t device = 0, inode = 0, bytes = 0;
  std::int64_t modified = 0;             ///< ns by the file system's clock
  std::chrono::nanoseconds age{};        ///< since the last change of the file or of its name
  std::optional<std::uint64_t> content;  ///< a hash, where `modified` alone would not tell
};

/// Looks at a list of files again and again.
///
/// A change is another device, inode, length or time of modification. A file system's clock is
/// coarse (a few ms; 2 s on FAT): two changes within a tick have one time. The contents of files
/// that were changed within kYoung are therefore compared as well. Not noticed is a change that
/// keeps length and inode, and then either has its time set back, or comes more than kYoung after
/// its stated time because the clock of a file server is that far behind.
class FileWatch {
 public:
  /// Two ticks of the coarsest clock.
  static constexpr std::chrono::seconds kYoung{4};

  /// Files that nobody touched for so long are at rest at the first look.
  explicit FileWatch(std::chrono::nanoseconds rest) : rest_(rest) {}

  /// Looks at the files, which may be others than before.
  void look(const std::vector<std::filesystem::path>& files);

  /// Whether there was a change since take(), or take() was never called.
  bool changed() const { return changed_; }

  /// changed(), and the two latest looks found the same: nobody is in the middle of writing.
  bool ready() const { return changed_ && at_rest_; }

  /// What is there now is known.
  void take() { changed_ = false; }

  /// As though there had been a change, which is at rest.
  void pretend_change() { changed_ = true; }

 private:
  std::chrono::nanoseconds rest_;
  std::vector<FileStamp> latest_;
  bool looked_ = false, changed_ = true, at_rest_ = false;
};

}  // namespace sir::viewer
