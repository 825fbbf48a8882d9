// The words behind a command, taken one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "modeler/commands.h"
#include "modeler/interpreter.h"

namespace sir::modeler {

/// Every kind of word that is missing or wrong throws CommandError, which shows the command's form.
class Interpreter::Arguments {
 public:
  /// `text` is the whole command, as it is remembered.
  Arguments(const CommandInfo& info, std::vector<std::string> words, std::string text)
      : info_(info), words_(std::move(words)), text_(std::move(text)) {}

  const std::string& text() const { return text_; }

  std::size_t left() const { return words_.size() - at_; }
  const std::string& next() {
    if (left() == 0) fail();
    return words_[at_++];
  }
  const std::string& peek() const { return words_[at_]; }

  /// Takes this word off the end where it is there, and another before it.
  bool take_last(std::string_view english, std::string_view portuguese) {
    if (left() < 2 || !is_word(words_.back(), english, portuguese)) return false;
    words_.pop_back();
    return true;
  }

  double number();
  bool number_follows() const;
  glm::dvec3 vector();
  std::int64_t count(const char* what);
  std::vector<double> numbers();

  /// Three numbers, or one for all three where no other follows it; none of them negative.
  glm::dvec3 colour(const char* what);

  /// Refuses words that are left over.
  void end() const {
    if (left() > 0) fail();
  }
  [[noreturn]] void fail() const;

 private:
  std::string_view form_meant() const;

  const CommandInfo& info_;
  std::vector<std::string> words_;  // the command first
  std::string text_;
  std::size_t at_ = 1;
};

}  // namespace sir::modeler
