// Where a text file's bytes come from, and how many of them are in memory at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace sir {

/// A file that is read a piece at a time, once its encoding, which the last byte may settle, is
/// known. A large file is read twice for that. Kept whole is a small one, which may then be edited
/// meanwhile, and what is no regular file, such as a pipe: that can be read but once. Lines above
/// kMaxLine bytes, files above kMaxFile and streams above kMaxStream are refused on the first way
/// through, as far as it gets.
class TextSource {
 public:
  /// Opens the file and reads it through once. Throws FileError.
  explicit TextSource(const std::filesystem::path& path);

  /// Whether it is UTF-8; else ISO-8859-1.
  bool utf8() const { return utf8_; }

  /// Bytes in all.
  std::size_t size() const { return size_; }

  /// Appends the next piece as it stands in the file; false at the end. `line` is told in the
  /// FileError where the file cannot be read any further.
  bool read(std::string& text, std::size_t line);

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 16;
  static constexpr std::size_t kKept = std::size_t{1} << 20;  // bytes of a small file, at most

  void look_through(bool keep, std::size_t stated, std::size_t most);
  std::size_t current_line();
  [[noreturn]] void fail(std::size_t line, const std::string& reason) const;

  std::string name_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{nullptr, std::fclose};
  std::string kept_;  ///< all of it
  bool utf8_ = true;
  std::size_t size_ = 0;
};

}  // namespace sir
