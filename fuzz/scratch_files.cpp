#include "fuzz/scratch_files.h"

#include <stdlib.h>

#include <stdexcept>
#include <string>
#include <system_error>

namespace sir::fuzz {
namespace {

namespace fs = std::filesystem;

fs::path memory_or_disk() {
  std::error_code ignored;
  const fs::path memory = "/dev/shm";
  return fs::is_directory(memory, ignored) ? memory : fs::temp_directory_path();
}

bool is_plain(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || letter == '.';
}

}  // namespace

ScratchFiles::ScratchFiles() {
  std::string name = (memory_or_disk() / "sir-fuzz-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder: " + name);
  folder_ = name;
}

ScratchFiles::~ScratchFiles() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

fs::path ScratchFiles::locate(std::string_view named) {
  constexpr std::size_t kLongest = 16;
  used_ = true;
  std::string name;
  for (const char letter : named)
    if (is_plain(letter)) name += letter;
  if (name.size() > kLongest) name.erase(0, name.size() - kLongest);
  while (!name.empty() && name.front() == '.') name.erase(0, 1);
  return folder_ / (name.empty() ? "file" : name);
}

void ScratchFiles::clear() {
  if (!used_) return;
  for (const auto& entry : fs::directory_iterator(folder_)) fs::remove_all(entry.path());
  used_ = false;
}

}  // namespace sir::fuzz
