// Lines of standard input, for commands that answer one line with one line (the
// thesis has none).
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace sir::cli {

/// A longer line counts as bad; its rest is not kept in memory.
inline constexpr std::size_t kLongestLine = std::size_t{1} << 16;

/// Calls `answer` for each line read from the descriptor, without its end;
/// too_long stands for a line of more than kLongestLine bytes, of which nothing
/// is given, as soon as it is that long. Calls `flush`
/// whenever more has to be waited for, so that one who asks line by line gets
/// each answer at once, and at the end. False where a signal ended it. Throws
/// FileError where reading fails.
bool for_each_line(int descriptor,
                   const std::function<void(std::string_view line, bool too_long)>& answer,
                   const std::function<void()>& flush);

}  // namespace sir::cli
