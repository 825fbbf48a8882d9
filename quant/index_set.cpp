#include "quant/index_set.h"

#include <charconv>
#include <cstddef>

namespace sir::quant {

bool parse_indices(std::string_view text, IndexSet& set) {
  IndexSet read;
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto read_index = [&](std::size_t& index) {
    const auto [stop, failure] = std::from_chars(at, end, index);
    at = stop;
    return failure == std::errc{} && index < kLutEntries;
  };
  while (true) {
    std::size_t first = 0;
    if (!read_index(first)) return false;
    std::size_t last = first;
    if (at != end && *at == '-' && (++at, !read_index(last) || last < first)) return false;
    for (std::size_t i = first; i <= last; ++i) read.set(i);
    if (at == end) break;
    if (*at++ != ',') return false;
  }
  set = read;
  return true;
}

}  // namespace sir::quant
