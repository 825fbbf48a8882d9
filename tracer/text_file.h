// Text files of the laboratory: lines, keywords and numbers (BASICO, thesis 3.3).
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sir {

/// Folds a keyword: no case, no accents, no surrounding white space
/// ("UNIÃO" and "uniao" become the same). Input and output are UTF-8.
std::string fold_keyword(std::string_view text);

/// One finite decimal number in the C locale, the whole of `token`
/// (a leading + is allowed). False for anything else.
bool parse_number(std::string_view token, double& value);

/// One non-negative integer up to 2^63-1, the whole of `token`.
bool parse_count(std::string_view token, std::int64_t& value);

/// `text` in quotation marks, as an error message shows it: what would disturb
/// a terminal as "?", and no more than the first 40 bytes.
std::string in_quotes(std::string_view text);

/// "1 light", "2 lights".
template <std::integral Count>
std::string counted(Count count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

/// Splits at white space.
std::vector<std::string_view> split_tokens(std::string_view line);

/// Reads a text file line by line. The file is UTF-8, else ISO-8859-1; lines
/// end in LF or CRLF; blank lines are passed over. Every error is a FileError
/// that names the file and the line. Lines are at most kMaxLine bytes long,
/// files at most kMaxFile.
class TextFile {
 public:
  static constexpr std::size_t kMaxLine = std::size_t{1} << 20;
  static constexpr std::size_t kMaxFile = std::size_t{1} << 30;

  /// Reads the whole file. Throws FileError.
  explicit TextFile(const std::filesystem::path& path);

  /// The same for a text in memory; `name` stands for the file in errors.
  TextFile(std::string name, std::string text);

  /// Moves to the next line that is not blank; false at the end of the file.
  bool next();

  /// Moves to the next line, or fails with "the file ends where `what` should stand".
  void expect(std::string_view what);

  /// The current line without surrounding white space, in UTF-8.
  std::string_view line() const { return line_; }

  /// Number of the current line, from 1.
  std::size_t line_number() const { return number_; }

  /// Puts the current line back, to be read again by next().
  void put_back() { put_back_ = true; }

  /// Whether a line that is not blank remains.
  bool at_end();

  /// Reads the next line as exactly values.size() numbers.
  void read_numbers(std::string_view what, std::span<double> values);

  /// Reads the next line as one non-negative integer.
  std::int64_t read_count(std::string_view what);

  /// The numbers on the current line; fails on a token that is none.
  std::vector<double> numbers_here(std::string_view what) const;

  [[noreturn]] void fail(std::string_view reason) const;
  [[noreturn]] void fail_at(std::size_t line, std::string_view reason) const;

  const std::string& name() const { return name_; }

 private:
  void settle_encoding();

  std::string name_;
  std::string text_;
  std::size_t position_ = 0;
  std::size_t number_ = 0;
  std::string_view line_;
  bool put_back_ = false;
};

}  // namespace sir
