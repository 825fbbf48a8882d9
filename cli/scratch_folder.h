// A folder for files that nobody keeps.
#pragma once

#include <filesystem>

namespace sir::cli {

/// New and empty; goes away with its content. Throws FileError where it cannot be made.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace sir::cli
