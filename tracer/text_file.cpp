#include "tracer/text_file.h"

#include <locale.h>
#include <utf8proc.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "tracer/error.h"
#include "tracer/utf8.h"

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
    : name_(path.string()), source_(path), utf8_(source_->utf8()), size_(source_->size()) {
  read_on();
  skip_byte_order_mark();
}

TextFile::TextFile(std::string name, std::string text)
    : name_(std::move(name)), text_(std::move(text)), utf8_(is_utf8(text_)), size_(text_.size()) {
  skip_byte_order_mark();
}

void TextFile::skip_byte_order_mark() {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text_.starts_with(kByteOrderMark)) position_ = kByteOrderMark.size();
}

bool TextFile::read_on() {
  if (!source_) return false;
  text_.erase(0, position_);
  position_ = 0;
  if (source_->read(text_, number_ + 1)) return true;
  source_.reset();
  return false;
}

std::string TextFile::whole() {
  while (read_on()) continue;
  const std::string_view text = std::string_view(text_).substr(position_);
  return utf8_ ? std::string(text) : latin1_to_utf8(text);
}

bool TextFile::next() {
  if (put_back_) {
    put_back_ = false;
    return true;
  }
  for (;;) {
    auto end = text_.find('\n', position_);
    if (end == text_.npos) {
      if (read_on()) continue;
      end = text_.size();
      if (position_ >= end) return false;
    }
    line_ = trim(std::string_view(text_).substr(position_, end - position_));
    position_ = std::min(end + 1, text_.size());
    ++number_;
    if (line_.empty()) continue;
    if (!utf8_) line_ = decoded_ = latin1_to_utf8(line_);
    return true;
  }
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
