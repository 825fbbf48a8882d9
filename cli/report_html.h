// The report of `sir table --html`: one page that explains itself (thesis 4.4).
#pragma once

#include <filesystem>
#include <string>

#include "cli/table_data.h"

namespace sir::cli {

/// A page that needs nothing but itself: no script, pictures as data: URIs,
/// drawings as inline SVG. `scratch`: a folder for pictures that nobody keeps.
std::string report_html(const TableData& data, const std::filesystem::path& scratch);

}  // namespace sir::cli
