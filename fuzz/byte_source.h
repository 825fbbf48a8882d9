// Structure out of bytes: whatever they are, they say something.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "fuzz/target.h"

namespace sir::fuzz {

/// Takes bytes off the front; past the end all are 0.
class ByteSource {
 public:
  explicit ByteSource(Bytes bytes) : rest_(bytes) {}

  std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const std::uint8_t first = rest_.front();
    rest_ = rest_.subspan(1);
    return first;
  }

  /// 0 to count - 1; count is at most 256.
  int below(int count) { return byte() % count; }
  bool flag() { return (byte() & 1) != 0; }

  /// A coordinate. Most are quarters from -4 to 3.75, on which faces coincide and rays run in
  /// faces; some are sixteenths moved by a few units in the last place, or of any size from 2^-32
  /// to 2^38, or no neat numbers.
  double coordinate();

  /// Like a coordinate, but never 0: a length, perhaps of a mirrored axis.
  double extent();

  /// From 0 to 1 in steps of 1/16, once in a while more.
  double share();

  std::size_t left() const { return rest_.size(); }

 private:
  Bytes rest_;
};

}  // namespace sir::fuzz
