// A number that stands for a picture: the memory of golden frames (the thesis has none).
#pragma once

#include <cstdint>
#include <span>

#include "eltek/screen.h"

namespace sir::eltek {

/// FNV-1a of 64 bits (Fowler, Noll, Vo) over bytes.
std::uint64_t hash(std::span<const std::uint8_t> bytes);

/// The same over the pixels as seen, r, g, b of each, rows from the top.
std::uint64_t hash(const Screen& screen);

}  // namespace sir::eltek
