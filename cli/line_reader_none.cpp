// Where there is no libedit.
#include "cli/line_reader.h"

namespace sir::cli {

std::unique_ptr<LineReader> make_editing_reader(const LineOptions&) { return nullptr; }

}  // namespace sir::cli
