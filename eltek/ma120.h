// The Eltek MA120, the laboratory's display (thesis 3.4).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "eltek/frame_buffer.h"
#include "eltek/lut_ports.h"
#include "eltek/pixel_address.h"
#include "eltek/screen.h"

namespace sir::eltek {

/// The device is its parts. A pixel passes through them in this order:
///
///   frame_buffer -> pixel mask -> LUT (both in lut_ports) -> dac -> blanking -> Screen
///
/// A program reaches it by its registers (Bus); those that know the parts use them directly.
///
/// The thesis says: 1024 x 780 pixels, 8 planes, 256 entries, 0..63 for each
/// primary. How the parts are reached, a linear DAC and square pixels are our
/// model. After power-on everything is 0, both masks are open and blanking is off.
///
/// The MA120's DAC has 6 bits per primary. Another may be fitted, as if the
/// machine had been built with it; all else stays.
class Ma120 {
 public:
  static constexpr ImageSize kSize{FrameBuffer::kColumns, FrameBuffer::kRows};

  /// Throws std::invalid_argument for other than 1 to 8 bits per primary.
  explicit Ma120(const quant::DacBits& dac = {}) : lut_ports(dac) {}

  FrameBuffer frame_buffer;
  LutPorts lut_ports;
  PixelAddress pixel_address;

  /// While it is on, what is scanned out is black whatever the LUT; the parts work as ever.
  bool blanked = false;

  /// The DAC that is fitted.
  const quant::DacBits& dac() const { return lut_ports.dac(); }

  /// Scans out one row, from the top: kSize.width colours as seen.
  void scan_line(int row, std::span<Rgb8, FrameBuffer::kColumns> line) const;

  /// Scans out the whole screen.
  Screen scan_out() const;

  /// The colour that each index in memory is seen as, past mask, LUT, DAC and blanking: a pixel of
  /// index i is scanned out as seen()[i].
  std::array<Rgb8, 256> seen() const;

  /// Scans out an area by somebody else's table, as one of words made of seen(): a pixel whose
  /// index in memory is i gives words_of[i] (mask, LUT and blanking have no part in it). Row j of
  /// the area begins at word j * stride; what lies between rows stays as it is. Throws
  /// std::out_of_range for an area that leaves the screen, std::invalid_argument for a stride of
  /// less than a row and for too few words.
  void scan_out_words(const Area& area, std::span<const std::uint32_t, 256> words_of,
                      std::span<std::uint32_t> words, std::size_t stride) const;

  /// The whole screen before the LUT, for captures that keep the LUT's order. While it is blanked
  /// all entries are black.
  IndexedScreen capture() const;

  /// The 256 entries as seen, whatever the pixel mask and the blanking.
  std::array<Rgb8, 256> palette() const;
};

}  // namespace sir::eltek
