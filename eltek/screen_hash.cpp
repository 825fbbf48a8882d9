#include "eltek/screen_hash.h"

#include <array>

#include "tracer/fnv1a.h"

namespace sir::eltek {

std::uint64_t hash(std::span<const std::uint8_t> bytes) { return fnv1a(std::as_bytes(bytes)); }

std::uint64_t hash(const Screen& screen) {
  std::uint64_t result = fnv1a({});
  for (const Rgb8 pixel : screen.pixels) {
    const std::array channels{std::byte{pixel.r}, std::byte{pixel.g}, std::byte{pixel.b}};
    result = fnv1a(channels, result);
  }
  return result;
}

}  // namespace sir::eltek
