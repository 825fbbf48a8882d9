// Letting gnuplot draw.
#pragma once

#include <string>

namespace sir::cli {

struct Drawing {
  std::string svg;      ///< what the script wrote to standard output; empty where it failed
  std::string failure;  ///< why there is none: "gnuplot is not installed"
};

/// Runs the gnuplot of PATH over a script, without the person's own settings, for
/// half a minute at most. Nothing is thrown: a page does without its plots.
Drawing draw(const std::string& script);

}  // namespace sir::cli
