// What the scripts of all plots of the price list have in common.
#pragma once

#include <cstddef>
#include <string>

namespace sir::cli {

/// Colours that can be told from white and from black, and from one another: one for each number,
/// again from the first where there are too many.
const char* plot_colour(std::size_t number);

/// A text in gnuplot's double quotes.
std::string plot_string(const std::string& text);

/// The terminal of so many pixels, the grid, the border, the key.
std::string plot_head(int width, int height);

/// Lines of data under a name: $name.
std::string plot_block(const std::string& name, const std::string& lines);

}  // namespace sir::cli
