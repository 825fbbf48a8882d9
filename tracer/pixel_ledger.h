// What is known of a pixel while its tree of rays is under way: rays that cannot
// change its bytes any more need not be cast (after Hall's adaptive control of
// the tree, thesis 2.4.2 and 3.3, but without loss).
#pragma once

#include <algorithm>
#include <limits>

#include "tracer/colour.h"

namespace sir {

/// Whether a level or more is to come to a channel that is not full: so it nearly
/// always is, and then the bytes are not known.
template <typename T>
bool level_to_come(const Colour<T>& come, const Colour<T>& awaited) {
  constexpr T kLevel = T(1) / 255;
  return (awaited.r > kLevel && come.r < 1) || (awaited.g > kLevel && come.g < 1) ||
         (awaited.b > kLevel && come.b < 1);
}

/// Whether all intensities from `come` to `come + awaited` give the same bytes, and
/// those beyond by `slack`.
template <typename T>
bool bytes_are_known(const Colour<T>& come, const Colour<T>& awaited, T slack) {
  if (level_to_come(come, awaited)) return false;
  for (int channel = 0; channel < 3; ++channel) {
    const T least = come[channel] - slack, most = come[channel] + awaited[channel] + slack;
    if (!(to_byte(least) == to_byte(most)) || !(most >= least)) return false;
  }
  return true;
}

/// Keeps two sums of intensities, channel by channel: what has come, and the
/// most that may still come. All contributions are 0 or more, so the pixel's
/// true intensity lies between the first and both together. The roundings of the
/// sums here, and of those that make the pixel, are bounded and added on both
/// sides.
template <typename T>
class PixelLedger {
 public:
  /// A new pixel: nothing has come yet. Without `sparing` nothing is ever decided.
  void open(bool sparing) {
    sparing_ = sparing;
    come_ = awaited_ = Colour<T>(0);
    largest_ = 0;
    entries_ = 0;
  }

  /// At most `most` more may come, summed up with so many roundings beyond those
  /// that the bound allows for.
  void expect(const Colour<T>& most, T roundings = 1) {
    awaited_ += most;
    largest_ += std::max({most.r, most.g, most.b});
    entries_ += roundings;
  }

  /// Of what was expected, `most` is no longer to come: it came as `came`, which
  /// is no more than that.
  void settle(const Colour<T>& most, const Colour<T>& came) {
    awaited_ -= most;
    come_ += came;
    largest_ += std::max({came.r, came.g, came.b});
    ++entries_;
  }

  /// Whether the bytes are the same whatever still comes.
  bool decided() const {
    if (!sparing_ || level_to_come(come_, awaited_)) return false;
    // Each entry rounds two sums here, and four times at most on its way to the
    // pixel; entries_ counts the terms that are still to be summed as well. No
    // sum was ever larger than all entries together.
    const T slack = 8 * (entries_ + 8) * std::numeric_limits<T>::epsilon() * largest_;
    return bytes_are_known(come_, awaited_, slack);
  }

 private:
  Colour<T> come_{0}, awaited_{0};
  T largest_ = 0;
  T entries_ = 0;
  bool sparing_ = false;
};

}  // namespace sir
