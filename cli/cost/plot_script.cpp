#include "cli/cost/plot_script.h"

#include <fmt/format.h>

#include <iterator>

namespace sir::cli {

const char* plot_colour(std::size_t number) {
  constexpr const char* kColours[] = {"#2f86a6", "#c2543c", "#6a9a2f", "#a060b8", "#c08a1e",
                                      "#3f9d86", "#808890", "#c05a8e", "#5560d0", "#8a6242"};
  return kColours[number % std::size(kColours)];
}

std::string plot_string(const std::string& text) {
  std::string word = "\"";
  for (const char c : text) word += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  return word + "\"";
}

std::string plot_head(int width, int height) {
  return fmt::format(
      "set terminal svg size {},{} dynamic noenhanced font \"sans-serif,13\"\n"
      "set encoding utf8\nset grid lc rgb \"#808890\" lw 0.5 dt 3\nset border 3\n"
      "set tics nomirror\nset key outside right top\n",
      width, height);
}

std::string plot_block(const std::string& name, const std::string& lines) {
  return "$" + name + " << END_OF_DATA\n" + lines + "END_OF_DATA\n";
}

}  // namespace sir::cli
