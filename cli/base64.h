// Bytes as text, for pictures within a page (RFC 4648; the thesis has no pages).
#pragma once

#include <string>
#include <string_view>

namespace sir::cli {

/// Base64 with padding, on one line.
std::string base64(std::string_view bytes);

}  // namespace sir::cli
