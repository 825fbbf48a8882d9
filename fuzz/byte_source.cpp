#include "fuzz/byte_source.h"

#include <cmath>
#include <limits>

namespace sir::fuzz {

double ByteSource::coordinate() {
  const int kind = below(16);
  const auto value = static_cast<std::int8_t>(byte());
  if (kind < 12) return (value % 16) * 0.25;
  if (kind == 12) return value / 16.0 * (1 + std::numeric_limits<double>::epsilon() * below(64));
  if (kind == 13) return std::ldexp(value, below(64) - 32);
  return value / 16.0 * (1 + byte() / 257.0);
}

double ByteSource::extent() {
  const double length = coordinate();
  return length == 0 ? 1 : length;
}

double ByteSource::share() {
  const int value = below(20);
  return value <= 16 ? value / 16.0 : value - 15.0;
}

}  // namespace sir::fuzz
