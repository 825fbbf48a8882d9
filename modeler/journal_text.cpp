#include "modeler/journal_text.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "modeler/interpreter.h"
#include "modeler/look_text.h"
#include "tracer/error.h"
#include "tracer/text_file.h"

namespace sir::modeler {
namespace {

// Lines "KEY ...". What may hold ends of lines has its size in the line, and stands behind it:
//   sir journal 1
//   begun 2026-11-22 21:50:07
//   folder 9
//   /home/who
//   from 0
//
//   camera window 4 3 ...        what was made up before the next command
//   read 4 10                    sizes of name and text
//   s.LUZ
//   0 0 .2 ...
//   do 3 - scale bola 2          so many commands can be undone after it; h: in a hand
constexpr std::string_view kTitle = "sir journal ";
constexpr std::string_view kVersion = "1";

std::string sized(std::string_view key, std::string_view bytes) {
  return fmt::format("{} {}\n{}\n", key, bytes.size(), bytes);
}

// Goes through the text as long as it is whole.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::size_t at() const { return at_; }
  std::size_t line() const { return line_; }  // the number of the last one

  std::optional<std::string_view> next_line() {
    const auto end = text_.find('\n', at_);
    if (end == text_.npos) return std::nullopt;
    return take(end - at_);
  }

  // So many bytes and the end of their line.
  std::optional<std::string_view> bytes(std::int64_t size) {
    const auto left = static_cast<std::int64_t>(text_.size() - at_);
    if (size >= left || text_[at_ + static_cast<std::size_t>(size)] != '\n') return std::nullopt;
    return take(static_cast<std::size_t>(size));
  }

  std::optional<std::string> sized(std::string_view key) {
    const auto line = next_line();
    std::int64_t size = 0;
    if (!line || !line->starts_with(key) || !parse_count(line->substr(key.size()), size))
      return std::nullopt;
    const auto found = bytes(size);
    return found ? std::optional(std::string(*found)) : std::nullopt;
  }

 private:
  std::string_view take(std::size_t size) {
    const std::string_view found = text_.substr(at_, size);
    line_ += 1 + static_cast<std::size_t>(std::count(found.begin(), found.end(), '\n'));
    at_ += size + 1;
    return found;
  }

  std::string_view text_;
  std::size_t at_ = 0, line_ = 0;
};

// Takes a word off the front.
std::string_view take_word(std::string_view& line) {
  const auto end = std::min(line.find(' '), line.size());
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(std::min(end + 1, line.size()));
  return word;
}

std::optional<Deed> next_deed(Reader& reader, Interpreter& cameras) {
  Deed deed;
  while (const auto found = reader.next_line()) {
    std::string_view line = *found;
    const std::string_view key = take_word(line);
    if (key == "camera") {
      try {
        cameras.execute(*found);
      } catch (const std::exception&) {
        return std::nullopt;
      }
      deed.made_up = cameras.looks().camera;
    } else if (key == "read") {
      std::int64_t name_size = 0, text_size = 0;
      if (!parse_count(take_word(line), name_size) || !parse_count(line, text_size))
        return std::nullopt;
      const auto name = reader.bytes(name_size);
      const auto text = name ? reader.bytes(text_size) : std::nullopt;
      if (!text) return std::nullopt;
      deed.files.push_back({std::string(*name), std::string(*text)});
    } else if (key == "do") {
      std::int64_t undoable = 0;
      if (!parse_count(take_word(line), undoable)) return std::nullopt;
      const std::string_view hand = take_word(line);
      if ((hand != "h" && hand != "-") || line.empty()) return std::nullopt;
      deed.undoable = static_cast<std::size_t>(undoable);
      deed.in_hand = hand == "h";
      deed.command = line;
      return deed;
    } else {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace

std::string journal_text(const JournalHead& head) {
  return fmt::format("{}{}\nbegun {}\n", kTitle, kVersion, head.time) +
         sized("folder", head.folder) + sized("from", head.from);
}

std::string journal_text(const Deed& deed) {
  std::string text;
  if (deed.made_up) text += camera_line(*deed.made_up) + "\n";
  for (const TextRead& file : deed.files)
    text += fmt::format("read {} {}\n{}\n{}\n", file.file.size(), file.text.size(), file.file,
                        file.text);
  return text.append(fmt::format("do {} {} ", deed.undoable, deed.in_hand ? 'h' : '-'))
      .append(deed.command)
      .append("\n");
}

Journal read_journal(const std::string& name, std::string_view text) {
  Reader reader(text);
  const auto title = reader.next_line();
  if (!title || !title->starts_with(kTitle)) throw FileError(name, 1, "this is no journal");
  if (const std::string_view version = title->substr(kTitle.size()); version != kVersion)
    throw FileError(name, 1,
                    fmt::format("a journal of version {}; this program reads version {}",
                                in_quotes(version), kVersion));
  Journal journal;
  const auto fail = [&] {
    throw FileError(name, reader.line() + 1, "the journal's head ends here");
  };
  const auto begun = reader.next_line();
  if (!begun || !begun->starts_with("begun ")) fail();
  journal.head.time = begun->substr(6);
  const auto folder = reader.sized("folder ");
  const auto from = folder ? reader.sized("from ") : std::nullopt;
  if (!from) fail();
  journal.head.folder = *folder;
  journal.head.from = *from;
  Interpreter cameras;
  journal.whole = reader.at();
  while (auto deed = next_deed(reader, cameras)) {
    journal.entries.push_back({std::move(*deed), reader.line()});
    journal.whole = reader.at();
  }
  return journal;
}

}  // namespace sir::modeler
