#include "modeler/arguments.h"

#include <algorithm>

#include <fmt/format.h>

#include "modeler/command_error.h"
#include "tracer/text_file.h"

namespace sir::modeler {

void Interpreter::Arguments::fail() const {
  throw CommandError(fmt::format("wrong number of words; it is {}{}{}{}", info_.name,
                                 info_.form.empty() ? "" : " ", form_meant(),
                                 words_.size() > 2 ? " (a name with spaces goes in quotes)" : ""));
}

double Interpreter::Arguments::number() {
  const std::string& word = next();
  double value = 0;
  if (!parse_number(word, value)) throw CommandError(in_quotes(word) + " is not a finite number");
  return value;
}

std::int64_t Interpreter::Arguments::count(const char* what) {
  const std::string& word = next();
  std::int64_t value = 0;
  if (!parse_count(word, value))
    throw CommandError(std::string(what) + " " + in_quotes(word) +
                       " is not a non-negative integer");
  return value;
}

std::vector<double> Interpreter::Arguments::numbers() {
  std::vector<double> values;
  while (left() > 0) values.push_back(number());
  return values;
}

// Of the ways to say it, the one that begins with the first word; else all.
std::string_view Interpreter::Arguments::form_meant() const {
  constexpr std::string_view kOr = " | ";
  for (std::string_view rest = info_.form; words_.size() > 1 && !rest.empty();) {
    const std::size_t end = std::min(rest.find(kOr), rest.size());
    const std::string_view way = rest.substr(0, end);
    if (way.front() >= 'a' && way.front() <= 'z' &&
        way.substr(0, way.find(' ')) == fold_keyword(words_[1]))
      return way;
    rest.remove_prefix(std::min(end + kOr.size(), rest.size()));
  }
  return info_.form;
}

bool Interpreter::Arguments::number_follows() const {
  double ignored = 0;
  return left() > 0 && parse_number(peek(), ignored);
}

glm::dvec3 Interpreter::Arguments::vector() {
  const double x = number(), y = number();
  return {x, y, number()};
}

glm::dvec3 Interpreter::Arguments::colour(const char* what) {
  glm::dvec3 colour(number());
  if (number_follows()) {
    colour.y = number();
    colour.z = number();
  }
  if (colour.x < 0 || colour.y < 0 || colour.z < 0)
    throw CommandError(std::string(what) + " must not be negative");
  return colour;
}

}  // namespace sir::modeler
