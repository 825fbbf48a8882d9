// A drawing by another program as a part of a page.
#pragma once

#include <string>
#include <string_view>

namespace sir::cli {

/// What a page takes of an SVG document: shapes and texts with their geometry and
/// colours, nothing that runs, styles or loads. Every id gets `prefix`, so that
/// drawings of one page do not mix; black becomes the page's own ink; groups
/// without content, and the names of fonts, are left out. `label` says what it shows.
/// Empty where the text is no such document.
std::string inline_svg(std::string_view svg, const std::string& prefix, const std::string& label);

/// Text as HTML shows it, in an attribute too.
std::string html_text(std::string_view text);

}  // namespace sir::cli
