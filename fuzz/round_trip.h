// A file that is read and written again reads the same.
#pragma once

#include <string>
#include <string_view>

#include "fuzz/refusal.h"
#include "fuzz/target.h"

namespace sir::fuzz {

/// Reads the bytes as a file of this name; if they are accepted, what was read is written, read
/// again and compared, and written again: both texts are one.
template <typename Read, typename Write, typename Same>
void play_round_trip(std::string_view name, Bytes bytes, const Read& read, const Write& write,
                     const Same& same) {
  accepts(name, text_of(bytes), [&](TextFile& file) {
    const auto first = read(file);
    const std::string text = write(first);
    const bool accepted = accepts("again", text, [&](TextFile& written) {
      const auto second = read(written);
      require(same(first, second), "what is written reads as what it was");
      require(write(second) == text, "what is read and written is the same text");
    });
    require(accepted, "what was read can be read again once it is written");
  });
}

}  // namespace sir::fuzz
