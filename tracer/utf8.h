// UTF-8 and what is not (thesis 3.6 wrote its files in the encoding of a PC of 1989).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sir {

/// Whether all of `text` is UTF-8.
bool is_utf8(std::string_view text);

/// How many bytes at the end of `text` may be a character of which the rest is to come: 0 to 3.
std::size_t unfinished_utf8(std::string_view text);

/// ISO-8859-1 in UTF-8.
std::string latin1_to_utf8(std::string_view text);

}  // namespace sir
