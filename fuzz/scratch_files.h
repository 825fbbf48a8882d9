// Files that a script may write and read, and no others.
#pragma once

#include <filesystem>
#include <string_view>

namespace sir::fuzz {

/// A folder of its own, in memory where the system has such (/dev/shm); it goes at the end.
class ScratchFiles {
 public:
  ScratchFiles();
  ~ScratchFiles();
  ScratchFiles(const ScratchFiles&) = delete;
  ScratchFiles& operator=(const ScratchFiles&) = delete;

  /// The file in the folder that stands for `named`, wherever that points to: letters, digits and
  /// dots of its end.
  std::filesystem::path locate(std::string_view named);

  /// Whether a file was asked for since clear().
  bool used() const { return used_; }

  /// Takes all files away.
  void clear();

 private:
  std::filesystem::path folder_;
  bool used_ = false;
};

}  // namespace sir::fuzz
