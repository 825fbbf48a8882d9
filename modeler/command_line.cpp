#include "modeler/command_line.h"

#include "modeler/command_error.h"

namespace sir::modeler {
namespace {

bool is_white(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

// Reads word after word.
struct Reader {
  std::string_view line;
  std::size_t at = 0;
  std::size_t begin = 0;  // of the word
  std::string word;
  bool open = false;  // in quotes

  void skip_white() {
    while (at < line.size() && is_white(line[at])) ++at;
  }
  bool in_comment() const { return at < line.size() && line[at] == '#'; }

  // False where there are no more.
  bool next() {
    skip_white();
    if (at >= line.size() || in_comment()) return false;
    begin = at;
    word.clear();
    for (; at < line.size(); ++at) {
      const char letter = line[at];
      if (letter == '"') open = !open;
      else if (open && letter == '\\' && at + 1 < line.size() &&
               (line[at + 1] == '"' || line[at + 1] == '\\'))
        word += line[++at];
      else if (!open && (is_white(letter) || letter == '#')) break;
      else word += letter;
    }
    return true;
  }
};

}  // namespace

std::vector<std::string> split_words(std::string_view line) {
  std::vector<std::string> words;
  Reader reader{line, 0, 0, {}, false};
  while (reader.next()) words.push_back(reader.word);
  if (reader.open) throw CommandError("a quote is opened and not closed");
  return words;
}

std::string_view without_comment(std::string_view line) {
  Reader reader{line, 0, 0, {}, false};
  reader.skip_white();
  const std::size_t begin = reader.at;
  std::size_t end = begin;
  while (reader.next()) end = reader.at;
  return line.substr(begin, end - begin);
}

std::string as_word(std::string_view text) {
  bool plain = !text.empty();
  for (const char letter : text)
    if (is_white(letter) || letter == '#' || letter == '"') plain = false;
  if (plain) return std::string(text);
  std::string word = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') word += '\\';
    word += letter;
  }
  return word + "\"";
}

UnfinishedWord unfinished_word(std::string_view line) {
  UnfinishedWord last;
  Reader reader{line, 0, 0, {}, false};
  while (reader.next()) {
    if (reader.at < line.size()) {
      last.before.push_back(reader.word);
      continue;
    }
    last.begin = reader.begin;
    last.text = reader.word;
    last.quoted = reader.open && line[reader.begin] == '"';
    return last;
  }
  last.in_comment = reader.in_comment();
  last.begin = line.size();
  return last;
}

}  // namespace sir::modeler
