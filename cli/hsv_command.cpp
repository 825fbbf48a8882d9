#include "cli/hsv_command.h"

#include <fmt/format.h>

#include <charconv>
#include <iterator>
#include <string>
#include <string_view>

#include "cli/line_input.h"
#include "quant/color_space.h"
#include "quant/grid.h"

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

/// Answers to lines, collected.
class Answers {
 public:
  void answer(std::string_view line, bool too_long) {
    if (too_long) return refuse("the line is too long");
    if (without_leading_space(line).empty()) return;
    Rgb8 colour;
    if (!parse_colour(line, colour)) return refuse("three integers from 0 to 255 expected");
    ++lines_;
    const auto to = std::back_inserter(text_);
    const quant::Hsv true_value = quant::hsv_of(colour);
    fmt::format_to(to, R"({{"h":{:.17g},"s":{:.17g},"v":{:.17g},)", true_value.h, true_value.s,
                   true_value.v);
    const auto [h, s, v] = grid_.point(grid_.cell(colour));
    if (h == grid_.grey_plane()) fmt::format_to(to, "\"grey\":{}}}\n", v);
    else fmt::format_to(to, "\"bin\":[{},{},{}]}}\n", h, s, v);
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
  void refuse(std::string_view reason) {
    ++lines_;
    ++bad_;
    fmt::format_to(std::back_inserter(text_), "{{\"error\":\"{}\"}}\n", reason);
  }

  quant::HsvGrid grid_;
  fmt::memory_buffer text_;
  std::size_t lines_ = 0, bad_ = 0;
};

}  // namespace

int run_hsv(int descriptor, const Session& session) {
  Answers answers;
  const bool whole = for_each_line(
      descriptor, [&](std::string_view line, bool too_long) { answers.answer(line, too_long); },
      [&] { answers.flush(); });
  if (!whole) return kInterrupted;
  detail(session, fmt::format("{} colours answered, {} bad lines", answers.lines() - answers.bad(),
                              answers.bad()));
  return answers.bad() == 0 ? kDone : kFailed;
}

}  // namespace sir::cli
