#include "eltek/screen_hash.h"

namespace sir::eltek {
namespace {

constexpr std::uint64_t kStart = 0xCBF29CE484222325u;

std::uint64_t mix(std::uint64_t hash, std::uint8_t byte) {
  constexpr std::uint64_t kPrime = 0x100000001B3u;
  return (hash ^ byte) * kPrime;
}

}  // namespace

std::uint64_t hash(std::span<const std::uint8_t> bytes) {
  std::uint64_t result = kStart;
  for (const std::uint8_t byte : bytes) result = mix(result, byte);
  return result;
}

std::uint64_t hash(const Screen& screen) {
  std::uint64_t result = kStart;
  for (const Rgb8 pixel : screen.pixels) result = mix(mix(mix(result, pixel.r), pixel.g), pixel.b);
  return result;
}

}  // namespace sir::eltek
