// `sir table` as text and as JSON (thesis 4.4).
#pragma once

#include <string>

#include "cli/table_data.h"

namespace sir::cli {

std::string table_text(const TableData& data);
std::string table_json(const TableData& data);

}  // namespace sir::cli
