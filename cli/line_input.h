// Lines of standard input, of bounded length.
#pragma once

#include <cstddef>
#include <istream>
#include <string>

namespace sir::cli {

/// Reads one line without its end; false when the input has ended. Of a line
/// longer than `limit` bytes the rest is passed over, and `too_long` set.
inline bool read_line(std::istream& in, std::string& line, bool& too_long,
                      std::size_t limit = 1 << 16) {
  line.clear();
  too_long = false;
  auto* buffer = in.rdbuf();
  for (int letter = buffer->sbumpc();; letter = buffer->sbumpc()) {
    if (letter == std::istream::traits_type::eof()) return !line.empty() || too_long;
    if (letter == '\n') return true;
    if (line.size() < limit) line += static_cast<char>(letter);
    else too_long = true;
  }
}

}  // namespace sir::cli
