// What a fuzz target is: a function that is played over bytes that anyone may have written.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace sir::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// A promise of the program that some bytes have broken. Targets let it pass, as they do every
/// exception that the program should not have thrown: libFuzzer keeps the bytes, tests fail.
struct Broken : std::logic_error {
  using std::logic_error::logic_error;
};

inline void require(bool kept, std::string_view promise) {
  if (!kept) throw Broken(std::string(promise));
}

inline std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Plays one input. Deterministic, in one thread, and without trace on the disk; what it does is
/// bounded by limits of its own, so that thousands of inputs a second are played (hundreds of whole
/// scenes).
using Play = void (*)(Bytes);

}  // namespace sir::fuzz
