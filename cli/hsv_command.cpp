#include "cli/hsv_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "cli/interrupt.h"
#include "quant/color_space.h"
#include "quant/grid.h"
#include "tracer/error.h"

namespace sir::cli {
namespace {

constexpr bool is_space(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

std::string_view without_leading_space(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  return text;
}

/// Three integers from 0 to 255 and nothing else.
bool parse_colour(std::string_view line, Rgb8& colour) {
  for (std::uint8_t* const byte : {&colour.r, &colour.g, &colour.b}) {
    line = without_leading_space(line);
    const auto [stop, failure] = std::from_chars(line.data(), line.data() + line.size(), *byte);
    if (failure != std::errc{}) return false;
    line.remove_prefix(static_cast<std::size_t>(stop - line.data()));
    if (!line.empty() && !is_space(line.front())) return false;
  }
  return without_leading_space(line).empty();
}

/// Answers lines that come in pieces.
class Answers {
 public:
  /// Answers every line that ends in `piece`; keeps the rest for the next one.
  void feed(std::string_view piece) {
    for (auto end = piece.find('\n'); end != std::string_view::npos; end = piece.find('\n')) {
      finish(piece.substr(0, end));
      piece.remove_prefix(end + 1);
    }
    keep(piece);
  }

  /// Answers a last line that no line end follows.
  void end() {
    if (!rest_.empty() || too_long_) finish({});
  }

  /// Prints what has been answered so far.
  void flush() {
    print({text_.data(), text_.size()});
    flush_output();
    text_.clear();
  }

  std::size_t lines() const { return lines_; }
  std::size_t bad() const { return bad_; }

 private:
  void keep(std::string_view part) {
    // A line without end must not fill the memory: its rest is dropped.
    too_long_ = too_long_ || rest_.size() + part.size() > kLongestLine;
    if (!too_long_) rest_.append(part);
  }

  void finish(std::string_view part) {
    if (rest_.empty() && !too_long_ && part.size() <= kLongestLine) {
      answer(part);
      return;
    }
    keep(part);
    if (too_long_) refuse("the line is too long");
    else answer(rest_);
    rest_.clear();
    too_long_ = false;
  }

  void answer(std::string_view line) {
    if (without_leading_space(line).empty()) return;
    Rgb8 colour;
    if (!parse_colour(line, colour)) {
      refuse("three integers from 0 to 255 expected");
      return;
    }
    ++lines_;
    const auto to = std::back_inserter(text_);
    const quant::Hsv true_value = quant::hsv_of(colour);
    fmt::format_to(to, R"({{"h":{:.17g},"s":{:.17g},"v":{:.17g},)", true_value.h, true_value.s,
                   true_value.v);
    const auto [h, s, v] = grid_.point(grid_.cell(colour));
    if (h == grid_.grey_plane()) fmt::format_to(to, "\"grey\":{}}}\n", v);
    else fmt::format_to(to, "\"bin\":[{},{},{}]}}\n", h, s, v);
  }

  void refuse(std::string_view reason) {
    ++lines_;
    ++bad_;
    fmt::format_to(std::back_inserter(text_), "{{\"error\":\"{}\"}}\n", reason);
  }

  quant::HsvGrid grid_;
  fmt::memory_buffer text_;
  std::string rest_;  // of a line whose end has not come yet
  bool too_long_ = false;
  std::size_t lines_ = 0, bad_ = 0;
};

}  // namespace

int run_hsv(std::FILE* in, const Session& session) {
  Answers answers;
  std::vector<char> piece(std::size_t{1} << 18);
  // read() gives what a pipe holds, where fread would wait for a full buffer:
  // a program that asks line by line gets each answer at once.
  while (true) {
    const ssize_t got = ::read(::fileno(in), piece.data(), piece.size());
    if (interrupted()) return kInterrupted;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0)
      throw FileError("standard input", 0, std::string("cannot be read: ") + std::strerror(errno));
    if (got == 0) break;
    answers.feed({piece.data(), static_cast<std::size_t>(got)});
    answers.flush();
  }
  answers.end();
  answers.flush();
  detail(session, fmt::format("{} colours answered, {} bad lines", answers.lines() - answers.bad(),
                              answers.bad()));
  return answers.bad() == 0 ? kDone : kFailed;
}

}  // namespace sir::cli
