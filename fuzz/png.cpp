// Pictures that are given to `sir lut`, `sir show` and the rest as PNG files.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <zlib.h>

#include "fuzz/refusal.h"
#include "fuzz/targets.h"
#include "viewer/png_file.h"

namespace sir::fuzz {
namespace {

constexpr std::size_t kSignature = 8, kChunk = 12;  // length, type and CRC of a chunk

std::uint32_t word_at(Bytes bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (const std::uint8_t byte : bytes.subspan(at, 4)) word = word << 8 | byte;
  return word;
}

// The same with every chunk's check sum right: changed bytes get past it, to what they mean.
std::vector<std::uint8_t> with_right_sums(Bytes bytes) {
  std::vector<std::uint8_t> mended(bytes.begin(), bytes.end());
  for (std::size_t at = kSignature; at + kChunk <= mended.size();) {
    const std::size_t length = word_at(mended, at);
    if (length > mended.size() - at - kChunk) break;
    const auto sum = ::crc32(0, &mended[at + 4], static_cast<uInt>(length + 4));
    for (std::size_t i = 0; i < 4; ++i)
      mended[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
    at += kChunk + length;
  }
  return mended;
}

void play_one(Bytes bytes) {
  try {
    const Planes planes = viewer::parse_png("F.png", bytes);
    // IHDR stands first: length, type, width, height.
    require(planes.size.width == static_cast<int>(word_at(bytes, kSignature + 8)) &&
                planes.size.height == static_cast<int>(word_at(bytes, kSignature + 12)),
            "a picture has the size that its header says");
    for (const auto& channel : planes.channel)
      require(channel.size() == planes.size.pixels(), "a plane has a byte for each pixel");
  } catch (const FileError& error) {
    check_refusal(error, "F.png", {});
  }
}

}  // namespace

void play_png(Bytes bytes) {
  play_one(bytes);
  const auto mended = with_right_sums(bytes);
  if (!std::equal(mended.begin(), mended.end(), bytes.begin())) play_one(mended);
}

}  // namespace sir::fuzz
