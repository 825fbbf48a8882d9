#include "tracer/text_file.h"

#include <locale.h>
#include <utf8proc.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "tracer/error.h"
#include "tracer/memory_hints.h"

namespace sir {
namespace {

bool is_white(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

std::string_view trim(std::string_view text) {
  while (!text.empty() && is_white(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_white(text.back())) text.remove_suffix(1);
  return text;
}

// Takes the next token off the front of `line`; empty: there is none.
std::string_view take_token(std::string_view& line) {
  std::size_t from = 0;
  while (from < line.size() && is_white(line[from])) ++from;
  std::size_t to = from;
  while (to < line.size() && !is_white(line[to])) ++to;
  const auto token = line.substr(from, to - from);
  line.remove_prefix(to);
  return token;
}

// How many of the first bytes are surely ASCII, eight at a time.
std::size_t ascii_prefix(std::string_view text) {
  std::size_t size = 0;
  std::uint64_t eight = 0;
  for (; size + sizeof eight <= text.size(); size += sizeof eight) {
    std::memcpy(&eight, text.data() + size, sizeof eight);
    if ((eight & 0x8080808080808080u) != 0) break;
  }
  return size;
}

bool is_utf8(std::string_view text) {
  for (;;) {
    text.remove_prefix(ascii_prefix(text));
    if (text.empty()) break;
    utf8proc_int32_t unused = 0;
    const auto used = utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                                       static_cast<utf8proc_ssize_t>(text.size()), &unused);
    if (used <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(used));
  }
  return true;
}

std::string latin1_to_utf8(std::string_view text) {
  std::string result;
  result.reserve(text.size() + text.size() / 8);
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (code < 0x80) {
      result += letter;
    } else {
      result += static_cast<char>(0xC0 | (code >> 6));
      result += static_cast<char>(0x80 | (code & 0x3F));
    }
  }
  return result;
}

std::string read_all(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw FileError(name, 0, "is a folder");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(name.c_str(), "rb"),
                                                             std::fclose);
  if (!file) throw FileError(name, 0, std::string("cannot be read: ") + std::strerror(errno));
  std::setvbuf(file.get(), nullptr, _IONBF, 0);  // it is read in large pieces anyway
  std::string text;
  const auto announced = std::filesystem::file_size(path, ignored);  // a pipe has none
  if (!ignored) reserve_all(text, std::min<std::uintmax_t>(announced, TextFile::kMaxFile));
  const auto fail = [&](const std::string& reason) {
    const auto line = 1 + std::count(text.begin(), text.end(), '\n');
    throw FileError(name, static_cast<std::size_t>(line), reason);
  };
  std::array<char, 1 << 16> chunk;
  static_assert(chunk.size() <= TextFile::kMaxLine);
  std::size_t line_length = 0;  // of the last line so far
  while (const std::size_t got = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
    // Checked while reading, so that a line of gigabytes costs a megabyte. Lines
    // that begin and end in one piece are short enough.
    const std::string_view piece(chunk.data(), got);
    const auto first_end = piece.find('\n');
    if (line_length + std::min(first_end, got) > TextFile::kMaxLine)
      fail("the line is longer than " + std::to_string(TextFile::kMaxLine) + " bytes");
    line_length = first_end == piece.npos ? line_length + got : got - 1 - piece.rfind('\n');
    text += piece;
    if (text.size() > TextFile::kMaxFile)
      fail("the file is longer than " + std::to_string(TextFile::kMaxFile) + " bytes");
  }
  if (std::ferror(file.get())) fail("cannot be read further");
  return text;
}

}  // namespace

std::string fold_keyword(std::string_view text) {
  text = trim(text);
  utf8proc_uint8_t* folded = nullptr;
  const auto length = utf8proc_map(
      reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
      static_cast<utf8proc_ssize_t>(text.size()), &folded,
      static_cast<utf8proc_option_t>(UTF8PROC_DECOMPOSE | UTF8PROC_STRIPMARK | UTF8PROC_CASEFOLD));
  const std::unique_ptr<utf8proc_uint8_t, void (*)(void*)> owner(folded, std::free);
  if (length < 0) return std::string(text);
  return std::string(reinterpret_cast<const char*>(folded), static_cast<std::size_t>(length));
}

std::string visible(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto code = static_cast<unsigned char>(text[i]);
    // U+0080 to U+009F, two bytes long, are control characters too.
    const bool high_control =
        code == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    shown += code < 0x20 || code == 0x7F || high_control ? '?' : text[i];
    if (high_control) ++i;
  }
  return shown;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kShown = 40;
  std::size_t end = text.size();
  if (end > kShown) {
    // Cut between characters, so that the message stays valid UTF-8.
    end = kShown;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  }
  return "\"" + visible(text.substr(0, end)) + (end < text.size() ? "...\"" : "\"");
}

bool parse_number(std::string_view token, double& value) {
  if (!token.empty() && token.front() == '+') {
    token.remove_prefix(1);
    if (!token.empty() && token.front() == '-') return false;
  }
  const char* end = token.data() + token.size();
  const auto [stop, code] = std::from_chars(token.data(), end, value);
  if (stop != end || token.empty()) return false;
  if (code == std::errc::result_out_of_range) {
    // from_chars does not tell too large from too small; strtod does.
    static const locale_t c_locale = ::newlocale(LC_ALL_MASK, "C", nullptr);
    value = ::strtod_l(std::string(token).c_str(), nullptr, c_locale);
  } else if (code != std::errc{}) {
    return false;
  }
  return std::isfinite(value);
}

bool parse_count(std::string_view token, std::int64_t& value) {
  const char* end = token.data() + token.size();
  const auto [stop, code] = std::from_chars(token.data(), end, value);
  return code == std::errc{} && stop == end && value >= 0 && !token.empty() && token.front() != '-';
}

std::vector<std::string_view> split_tokens(std::string_view line) {
  std::vector<std::string_view> tokens;
  for (auto token = take_token(line); !token.empty(); token = take_token(line))
    tokens.push_back(token);
  return tokens;
}

TextFile::TextFile(const std::filesystem::path& path)
    : name_(path.string()), text_(read_all(path)) {
  settle_encoding();
}

TextFile::TextFile(std::string name, std::string text)
    : name_(std::move(name)), text_(std::move(text)) {
  settle_encoding();
}

void TextFile::settle_encoding() {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text_.starts_with(kByteOrderMark)) text_.erase(0, kByteOrderMark.size());
  if (!is_utf8(text_)) text_ = latin1_to_utf8(text_);
}

bool TextFile::next() {
  if (put_back_) {
    put_back_ = false;
    return true;
  }
  while (position_ < text_.size()) {
    const auto end = std::min(text_.find('\n', position_), text_.size());
    line_ = trim(std::string_view(text_).substr(position_, end - position_));
    position_ = end + 1;
    ++number_;
    if (!line_.empty()) return true;
  }
  return false;
}

void TextFile::fail_at_end(std::string_view what) const {
  fail_at(number_ + (number_ == 0), "the file ends where " + std::string(what) + " should stand");
}

bool TextFile::at_end() {
  if (!next()) return true;
  put_back();
  return false;
}

std::size_t TextFile::parse_numbers(std::span<double> values, std::string_view& wrong) const {
  std::size_t count = 0;
  std::string_view rest = line_;
  for (auto token = take_token(rest); !token.empty(); token = take_token(rest)) {
    double value = 0;
    if (!parse_number(token, value)) {
      wrong = token;
      return count;
    }
    if (count < values.size()) values[count] = value;
    ++count;
  }
  return count;
}

void TextFile::fail_in_numbers(std::string_view what, std::string_view wrong) const {
  fail(std::string(what) + ": " + in_quotes(wrong) + " is not a finite number");
}

void TextFile::fail_in_numbers(std::string_view what, std::size_t wanted, std::size_t found) const {
  fail(std::string(what) + ": " + std::to_string(wanted) + " numbers expected, " +
       std::to_string(found) + " found");
}

std::vector<double> TextFile::numbers_here(std::string_view what) const {
  std::string_view wrong;
  std::vector<double> values(parse_numbers({}, wrong));
  if (!wrong.empty()) fail_in_numbers(what, wrong);
  parse_numbers(values, wrong);
  return values;
}

void TextFile::fail_in_count(std::string_view what) const {
  fail(std::string(what) + ": " + in_quotes(line_) + " is not a non-negative integer");
}

void TextFile::fail(std::string_view reason) const { throw FileError(name_, number_, reason); }

void TextFile::fail_at(std::size_t line, std::string_view reason) const {
  throw FileError(name_, line, reason);
}

}  // namespace sir
