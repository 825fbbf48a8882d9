#include "modeler/completion.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "modeler/command_line.h"
#include "modeler/commands.h"
#include "modeler/look_words.h"
#include "modeler/operations.h"
#include "tracer/names.h"
#include "tracer/text_file.h"

namespace sir::modeler {
namespace {

using Words = std::vector<std::string>;

// fold_keyword() takes white space off the ends, which counts here.
bool begins(std::string_view word, std::string_view typed) {
  return fold_keyword(std::string(word) + "|").starts_with([&] {
    std::string folded = fold_keyword("|" + std::string(typed) + "|");
    return folded.substr(1, folded.size() - 2);
  }());
}

template <typename Value>
void offer(std::span<const Word<Value>> known, std::string_view typed, Words& words) {
  for (const Word<Value>& word : known) {
    if (begins(word.english, typed)) words.emplace_back(word.english);
    // Portuguese where there is something of it to go by, or every word would come twice.
    else if (!typed.empty() && begins(word.portuguese, typed)) words.emplace_back(word.portuguese);
  }
}

void offer_commands(std::string_view typed, Words& words) {
  for (const CommandInfo& info : commands()) {
    if (begins(info.name, typed)) words.emplace_back(info.name);
    else if (!typed.empty() && begins(info.portuguese, typed)) words.emplace_back(info.portuguese);
  }
}

void offer_files(const std::string& typed, Words& words) {
  namespace fs = std::filesystem;
  const auto slash = typed.rfind('/');
  const std::string folder = slash == typed.npos ? "" : typed.substr(0, slash + 1);
  const std::string start = slash == typed.npos ? typed : typed.substr(slash + 1);
  std::error_code failure;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, failure), end;
       !failure && at != end; at.increment(failure)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with(start) || (start.empty() && name.starts_with('.'))) continue;
    std::error_code ignored;
    words.push_back(folder + name + (at->is_directory(ignored) ? "/" : ""));
  }
}

// Places in a tree, in their order, with what is there.
void offer_places(const Node& tree, std::string_view typed, Completion& completion) {
  const std::vector<const Node*> nodes = preorder(tree);
  for (std::size_t place = 0; place < nodes.size(); ++place) {
    const Node& node = *nodes[place];
    std::string number = std::to_string(place);
    if (!number.starts_with(typed) && !begins(node.name, typed)) continue;
    completion.words.push_back(std::move(number));
    const Primitive* primitive = node.primitive();
    const std::string_view what =
        primitive != nullptr ? name_of(primitive->kind) : name_of(node.composite()->operation);
    completion.notes.push_back(visible(node.name) + ": " + std::string(what));
  }
}

void offer_part_commands(std::string_view typed, Words& words) {
  for (const CommandInfo& info : commands()) {
    if (!is_for_parts(info.command)) continue;
    if (begins(info.name, typed)) words.emplace_back(info.name);
    else if (!typed.empty() && begins(info.portuguese, typed)) words.emplace_back(info.portuguese);
  }
}

// The command whose words stand at the end of the line, and how many of them are before the last:
// in an edit it is the part's, its name the place.
const CommandInfo* command_of(const Words& before, std::size_t& count) {
  const CommandInfo* info = find_command(before.front());
  count = before.size();
  if (info == nullptr || info->command != Command::edit || count < 4) return info;
  count -= 2;
  const CommandInfo* part = find_command(before[3]);
  return part != nullptr && is_for_parts(part->command) ? part : nullptr;
}

template <typename Value>
std::optional<Value> find(std::span<const Word<Value>> known, std::string_view word) {
  for (const Word<Value>& one : known)
    if (is_word(word, one.english, one.portuguese)) return one.value;
  return std::nullopt;
}

void offer_solids(const Interpreter& interpreter, std::string_view typed, Words& words) {
  for (const auto& [place, entry] : interpreter.solids().entries())
    if (begins(entry->name, typed)) words.push_back(entry->name);
}

bool is_number(std::string_view word) {
  double ignored = 0;
  return parse_number(word, ignored);
}

bool is_of_looks(char place) {
  return std::string_view("CLUFT").find(place) != std::string_view::npos;
}

// What goes on behind camera, light, surfaces, surface and script; `before` begins with that word.
void offer_looks(char place, const Interpreter& interpreter, const Words& before,
                 const std::string& typed, Words& words) {
  const bool first = before.size() == 1, second = before.size() == 2;
  const std::string& last = before.back();
  switch (place) {
    case 'C': {
      if (first) return offer(camera_words(), typed, words);
      const auto verb = find(camera_words(), before[1]);
      const auto word = find(camera_words(), last);
      if (verb == CameraWord::load || verb == CameraWord::save) {
        if (second) offer_files(typed, words);
      } else if (verb == CameraWord::frame) {
        if (second) offer_solids(interpreter, typed, words);
      } else if (word == CameraWord::focal) {
        if (begins("auto", typed)) words.emplace_back("auto");
      } else if (verb && *verb <= CameraWord::perspective &&
                 (is_number(last) || word == CameraWord::parallel ||
                  word == CameraWord::perspective || word == CameraWord::made_up)) {
        offer(camera_words().first(std::size_t(CameraWord::load)), typed, words);
      }
      return;
    }
    case 'L': {
      if (first) return offer(light_words(), typed, words);
      const auto verb = find(light_words(), before[1]);
      if (verb == LightWord::load || verb == LightWord::save) {
        if (second) offer_files(typed, words);
      } else if (verb == LightWord::set && (second || is_number(last))) {
        offer(light_words().first(std::size_t(LightWord::move)), typed, words);
      }
      return;
    }
    case 'U': {
      if (first) return offer(surfaces_words(), typed, words);
      if (second &&
          find(surfaces_words(), last).value_or(SurfacesWord::erase) != SurfacesWord::erase)
        offer_files(typed, words);
      return;
    }
    case 'F': {
      const auto word = find(surface_words(), last);
      const bool named = find(surface_words(), before[before.size() - 2]) == SurfaceWord::name;
      if (is_number(last) || named || word == SurfaceWord::plain || word == SurfaceWord::odd ||
          word == SurfaceWord::even)
        offer(surface_words(), typed, words);
      return;
    }
    case 'T':
      if (first) return offer(script_words(), typed, words);
      if (second && find(script_words(), last)) offer_files(typed, words);
      return;
    default: return;
  }
}

}  // namespace

Completion complete(const Interpreter& interpreter, std::string_view line) {
  const UnfinishedWord last = unfinished_word(line);
  Completion completion;
  completion.begin = last.begin;
  if (last.in_comment) return completion;
  Words& words = completion.words;
  const auto offer_word = [&](std::string_view word) {
    if (begins(word, last.text)) words.emplace_back(word);
  };
  std::size_t count = 0;
  if (last.before.empty()) {
    offer_commands(last.text, words);
  } else if (const CommandInfo* info = command_of(last.before, count);
             info != nullptr && !info->places.empty()) {
    const std::size_t place = std::min(count, info->places.size()) - 1;
    const bool beyond = count > info->places.size();
    const bool is_option = last.text.starts_with("--");
    const char letter = info->places[place];
    const bool goes_on = letter == 'f' || letter == 'm' || is_of_looks(letter);
    switch (beyond && !goes_on ? '-' : letter) {
      case 's': offer_solids(interpreter, last.text, words); break;
      case 'k': offer(kinds(), last.text, words); break;
      case 'o': offer(operations(), last.text, words); break;
      case 't': offer(transforms(), last.text, words); break;
      case 'a': offer(aspects(), last.text, words); break;
      case 'c': offer_commands(last.text, words); break;
      case 'E': offer_part_commands(last.text, words); break;
      case 'N':
        if (const EntryPtr solid = interpreter.solids().find(last.before[1]))
          offer_places(*solid->solid.tree(), last.text, completion);
        return completion;
      case 'p': offer_word("apart"); break;
      case 'm': offer_word("centre"); break;
      case 'h': offer_word("camera"); break;
      case 'V': offer(view_words(), last.text, words); break;
      case 'O': offer(switch_words(), last.text, words); break;
      case 'J':
        for (const char* option : {"--list", "--discard"}) offer_word(option);
        if (interpreter.keeping().names)
          for (const std::string& name : interpreter.keeping().names()) offer_word(name);
        break;
      case 'x':
        for (const char* axis : {"x", "y", "z"}) offer_word(axis);
        break;
      case 'f':
        if (info->command == Command::show && is_option)
          for (const char* option : {"--scene", "--shaded", "--size"}) offer_word(option);
        else if (!beyond || info->command == Command::show) offer_files(last.text, words);
        break;
      case '-': break;
      default: offer_looks(letter, interpreter, last.before, last.text, words); break;
    }
  }
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
  for (std::string& word : words) {
    const bool folder = word.ends_with('/');
    word = last.quoted ? as_word(word + " ") : as_word(word);
    if (last.quoted) word.erase(word.size() - 2, 1);
    // A folder's name goes on.
    if (folder && word.front() == '"') word.pop_back();
  }
  return completion;
}

std::string common_start(const std::vector<std::string>& words) {
  if (words.empty()) return {};
  std::size_t size = words.front().size();
  for (const std::string& word : words) {
    const auto [at, unused] =
        std::mismatch(words.front().begin(), words.front().end(), word.begin(), word.end());
    size = std::min(size, static_cast<std::size_t>(at - words.front().begin()));
  }
  // Not within a character.
  while (size > 0 && size < words.front().size() &&
         (static_cast<unsigned char>(words.front()[size]) & 0xC0) == 0x80)
    --size;
  return words.front().substr(0, size);
}

}  // namespace sir::modeler
