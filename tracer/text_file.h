// Text files of the laboratory: lines, keywords and numbers (BASICO, thesis 3.3).
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "tracer/text_source.h"

namespace sir {

/// Folds a keyword: no case, no accents, no surrounding white space
/// ("UNIÃO" and "uniao" become the same). Input and output are UTF-8.
std::string fold_keyword(std::string_view text);

/// One finite decimal number in the C locale, the whole of `token`
/// (a leading + is allowed). False for anything else.
bool parse_number(std::string_view token, double& value);

/// One non-negative integer up to 2^63-1, the whole of `token`.
bool parse_count(std::string_view token, std::int64_t& value);

/// A text as a terminal may show it: control characters are question marks.
std::string visible(std::string_view text);

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

/// What is being read, for an error's message: a text, or a function that makes it
/// when it is wanted, since most files have no error.
template <typename What>
concept Naming = std::convertible_to<const What&, std::string_view> ||
    std::is_invocable_r_v<std::string, const What&>;

/// Reads a text file line by line. The file is UTF-8, else ISO-8859-1; lines
/// end in LF or CRLF; blank lines are passed over. Every error is a FileError
/// that names the file and the line. No more than a piece of a large file is in
/// memory at once; what is too long for the limits of tracer/limits.h is refused.
class TextFile {
 public:
  /// Looks through the whole file. Throws FileError.
  explicit TextFile(const std::filesystem::path& path);

  /// The same for a text in memory; `name` stands for the file in errors.
  TextFile(std::string name, std::string text);

  /// Moves to the next line that is not blank; false at the end of the file.
  bool next();

  /// Moves to the next line, or fails with "the file ends where `what` should stand".
  void expect(const Naming auto& what) {
    if (!next()) fail_at_end(name_by(what));
  }

  /// The current line without surrounding white space, in UTF-8. It is gone after next().
  std::string_view line() const { return line_; }

  /// Number of the current line, from 1.
  std::size_t line_number() const { return number_; }

  /// Puts the current line back, to be read again by next().
  void put_back() { put_back_ = true; }

  /// Whether a line that is not blank remains.
  bool at_end();

  /// Reads the next line as exactly values.size() numbers.
  void read_numbers(const Naming auto& what, std::span<double> values) {
    expect(what);
    std::string_view wrong;
    const std::size_t found = parse_numbers(values, wrong);
    if (!wrong.empty()) fail_in_numbers(name_by(what), wrong);
    if (found != values.size()) fail_in_numbers(name_by(what), values.size(), found);
  }

  /// Reads the next line as one non-negative integer.
  std::int64_t read_count(const Naming auto& what) {
    expect(what);
    std::int64_t value = 0;
    if (!parse_count(line_, value)) fail_in_count(name_by(what));
    return value;
  }

  /// The numbers on the current line; fails on a token that is none.
  std::vector<double> numbers_here(std::string_view what) const;

  [[noreturn]] void fail(std::string_view reason) const;
  [[noreturn]] void fail_at(std::size_t line, std::string_view reason) const;

  const std::string& name() const { return name_; }

  /// Bytes of the whole text, as it stands in the file.
  std::size_t size() const { return size_; }

  /// The whole text, in UTF-8, for who keeps it; to be asked before the first next(). All of it is
  /// in memory from then on.
  std::string whole();

 private:
  static std::string name_by(const Naming auto& what) {
    if constexpr (std::invocable<decltype(what)>) return what();
    else return std::string(what);
  }

  // The numbers on the line, as many as there is room for; how many there are. `wrong`:
  // the first token that is none.
  std::size_t parse_numbers(std::span<double> values, std::string_view& wrong) const;
  [[noreturn]] void fail_at_end(std::string_view what) const;
  [[noreturn]] void fail_in_numbers(std::string_view what, std::string_view wrong) const;
  [[noreturn]] void fail_in_numbers(std::string_view what, std::size_t wanted,
                                    std::size_t found) const;
  [[noreturn]] void fail_in_count(std::string_view what) const;
  void skip_byte_order_mark();
  bool read_on();

  std::string name_;
  std::optional<TextSource> source_;  // none: the text is in memory, or all has been read
  std::string text_;                  // from somewhere before the current line
  bool utf8_;
  std::size_t size_;
  std::string decoded_;  // the current line, where the file is not UTF-8
  std::size_t position_ = 0;
  std::size_t number_ = 0;
  std::string_view line_;
  bool put_back_ = false;
};

}  // namespace sir
