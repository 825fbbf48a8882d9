#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "eltek/raster_position.h"
#include "eltek/trace_text.h"
#include "tracer/text_file.h"

namespace sir::eltek {
namespace {

constexpr std::string_view kHeader = "MA120 trace 1 dac R G B";

// What is wrong with a line; parse() says where.
struct Wrong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Takes words off the front of a line, as far as a comment.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line.substr(0, line.find('#'))) {}

  // Empty: there is none.
  std::string_view take() {
    const auto from = rest_.find_first_not_of(kWhite);
    if (from == rest_.npos) return rest_ = {};
    const auto to = std::min(rest_.find_first_of(kWhite, from), rest_.size());
    const auto word = rest_.substr(from, to - from);
    rest_.remove_prefix(to);
    return word;
  }

 private:
  static constexpr std::string_view kWhite = " \t\v\f\r";
  std::string_view rest_;
};

// Without case, of ASCII alone: unlike the laboratory's keywords, those of a trace have no accents
// to fold (fold_keyword), which would make two strings for each of a dozen comparisons on each of
// millions of lines.
bool same(std::string_view word, std::string_view keyword) {
  const auto lower = [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  };
  if (word.size() != keyword.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (lower(word[i]) != lower(keyword[i])) return false;
  return true;
}

// An integer from least to most; `what` names it in the error.
std::int64_t number(std::string_view word, std::int64_t least, std::int64_t most,
                    std::string_view what) {
  std::int64_t value = 0;
  if (!parse_count(word, value) || value < least || value > most) {
    const std::string range = std::to_string(least) + " to " + std::to_string(most);
    throw Wrong(std::string(what) + " takes an integer from " + range +
                (word.empty() ? "" : ", not " + in_quotes(word)));
  }
  return value;
}

quant::DacBits dac_bits(Words& words) {
  quant::DacBits dac;
  for (int& bits : dac.bits) bits = static_cast<int>(number(words.take(), 1, 8, "a DAC's primary"));
  return dac;
}

std::optional<Port> port_of(std::string_view word) {
  for (const Port port : kPorts)
    if (same(word, name(port))) return port;
  return std::nullopt;
}

std::uint16_t port_value(Port port, std::string_view word) {
  if (port != Port::blank)
    return static_cast<std::uint16_t>(number(word, 0, largest(port), name(port)));
  if (!same(word, "on") && !same(word, "off")) throw Wrong("blank takes on or off");
  return same(word, "on") ? 1 : 0;
}

std::optional<std::uint8_t> pixel_index(std::string_view digits, bool may_be_unknown) {
  if (may_be_unknown && digits == "?") return std::nullopt;
  std::uint8_t index = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, code] = std::from_chars(digits.data(), end, index, 16);
  if (digits.size() != 2 || code != std::errc{} || stop != end)
    throw Wrong(in_quotes(digits) + " is not an index of two hexadecimal digits" +
                (may_be_unknown ? " or ?" : ""));
  return index;
}

class Parser {
 public:
  Parser(TextFile& file) : file_(file) {}

  Trace parse() {
    if (!next()) file_.fail("the trace is cut off: it has no first line");
    if (!same(first_, "MA120") || !same(words_.take(), "trace"))
      file_.fail("no trace of the MA120, or one that is cut off: the first line is \"" +
                 std::string(kHeader) + "\"");
    at_line([this] { return header(); });
    while (next())
      if (at_line([this] { return line(); })) {
        if (next()) file_.fail("there is more after the end");
        return std::move(trace_);
      }
    file_.fail(
        "the trace is cut off: its last line, \"end\" and the number of records, is missing");
  }

 private:
  // On to a line with words.
  bool next() {
    while (file_.next()) {
      words_ = Words(file_.line());
      first_ = words_.take();
      if (!first_.empty()) return true;
    }
    return false;
  }

  // Errors get their place; what is wrong with the very last line may be that it is half.
  template <typename Step>
  bool at_line(const Step& step) {
    std::string reason;
    try {
      return step();
    } catch (const Wrong& wrong) {
      reason = wrong.what();
    }
    const std::size_t number = file_.line_number();
    file_.fail_at(number, (file_.at_end() ? "the trace is cut off here: " : "") + reason);
  }

  bool header() {
    if (const auto version = words_.take(); version != "1")
      throw Wrong("version " + in_quotes(version) + " of the trace is not known here; 1 is");
    if (!same(words_.take(), "dac")) throw Wrong("dac and its bits are missing");
    trace_.set_dac(dac_bits(words_));
    no_more();
    return true;
  }

  // True at the end line.
  bool line() {
    if (!trace_.has_room_for(0, 0) && !same(first_, "end"))
      throw Wrong("more than " + std::to_string(Trace::kMaxRecords) + " records");
    if (same(first_, "pixel")) {
      read_runs(false);
      trace_.add_pixel_write(runs_);
      return false;
    }
    if (same(first_, "read")) {
      read_access();
    } else if (same(first_, "wait")) {
      const auto line = number(words_.take(), 0, kTiming.lines - 1, "wait");
      trace_.add(Wait{static_cast<int>(line)});
    } else if (same(first_, "power")) {
      const PowerCycle power{dac_bits(words_)};
      require_room(0, Trace::kMaxBurst);
      trace_.add(power);
    } else if (same(first_, "end")) {
      end();
      return true;
    } else if (const auto port = port_of(first_)) {
      trace_.add(PortWrite{*port, port_value(*port, words_.take())});
    } else {
      throw Wrong(in_quotes(first_) + " is no register and no word of a trace");
    }
    no_more();
    return false;
  }

  void read_access() {
    const std::string_view word = words_.take();
    const auto port = port_of(word);
    if (!port) throw Wrong(in_quotes(word) + " is no register");
    if (*port == Port::pixel) {
      read_runs(true);
      trace_.add_pixel_read(runs_);
      return;
    }
    const std::string_view value = words_.take();
    PortRead read{*port, std::nullopt};
    if (value != "?") read.value = port_value(*port, value);
    trace_.add(read);
  }

  void read_runs(bool may_be_unknown) {
    runs_.clear();
    std::uint64_t pixels = 0;
    for (auto word = words_.take(); !word.empty(); word = words_.take()) {
      const auto star = word.find('*');
      const auto index = pixel_index(word.substr(0, star), may_be_unknown);
      std::int64_t count = 1;
      if (star != word.npos)
        count = number(word.substr(star + 1), 1, Trace::kMaxBurst, "a number of equal pixels");
      pixels += static_cast<std::uint64_t>(count);
      if (pixels > Trace::kMaxBurst)
        throw Wrong("more than " + std::to_string(Trace::kMaxBurst) +
                    " pixels, the screen's, at once");
      runs_.emplace_back(static_cast<std::uint32_t>(count), index);
    }
    if (runs_.empty()) throw Wrong("pixel takes indices of two hexadecimal digits");
    require_room(runs_.size(), pixels);
  }

  void require_room(std::size_t runs, std::uint64_t pixels) const {
    if (!trace_.has_room_for(runs, pixels))
      throw Wrong("more than " + std::to_string(Trace::kMaxPixels) + " pixels or " +
                  std::to_string(Trace::kMaxRuns) + " runs of them in all");
  }

  void end() {
    const auto stated = number(words_.take(), 0, std::int64_t{1} << 62, "end");
    no_more();
    const auto found = static_cast<std::int64_t>(trace_.records().size());
    if (stated != found)
      throw Wrong("the last line counts " + counted(stated, "record") + ", the trace has " +
                  std::to_string(found));
  }

  void no_more() {
    if (const auto word = words_.take(); !word.empty())
      throw Wrong(in_quotes(word) + " stands where the line should end");
  }

  TextFile& file_;
  Trace trace_;
  Words words_{""};
  std::string_view first_;
  std::vector<PixelRun> runs_;
};

}  // namespace

Trace read_trace(const std::filesystem::path& path) {
  TextFile file(path);
  return Parser(file).parse();
}

Trace parse_trace(std::string name, std::string text) {
  TextFile file(std::move(name), std::move(text));
  return Parser(file).parse();
}

}  // namespace sir::eltek
