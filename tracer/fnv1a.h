// A number that stands for bytes (the thesis has none).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace sir {

/// FNV-1a of 64 bits (Fowler, Noll, Vo) from a start of one's own choice: tells what was changed
/// by chance, not what was changed on purpose. Each byte's step is invertible, so bytes that
/// differ in one place never have the same number.
inline std::uint64_t fnv1a(std::span<const std::byte> bytes,
                           std::uint64_t hash = 0xCBF29CE484222325u) {
  constexpr std::uint64_t kPrime = 0x100000001B3u;
  for (const std::byte byte : bytes) hash = (hash ^ static_cast<std::uint8_t>(byte)) * kPrime;
  return hash;
}

}  // namespace sir
