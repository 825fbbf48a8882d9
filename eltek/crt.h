// The MA120's colour tube, as an sRGB screen can show it. The thesis says of colour nothing but
// codes from 0 to 63 (3.4): the ideal monitor takes those for sRGB bytes; this one is our model of
// a tube of the time.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "eltek/screen.h"
#include "eltek/tube.h"

namespace sir::eltek {

struct CrtOptions {
  static constexpr int kMaxScale = 8;
  static constexpr int kLeastScanLineScale = 3;  ///< with 2 all rows would be alike
  static constexpr double kLeastSpot = 0.1, kMaxSpot = 5;

  TubeOptions tube;
  int scale = 1;          ///< a pixel of the MA120 is shown as scale x scale pixels
  bool aspect = false;    ///< pixels 65:64 wide, as 1024 x 780 of them fill a tube of 4:3
  double spot = 0;        ///< standard deviation of the beam's spot in pixels of the MA120; 0: none
  double scan_lines = 0;  ///< 0 (none) to 1: what of the light is missing between two lines

  bool valid() const;

  /// Whether every pixel stays a pixel, so that the tube is a map of 256 colours.
  bool is_colour_map() const;

  friend bool operator==(const CrtOptions&, const CrtOptions&) = default;
};

/// code -> voltage (code / largest code) -> light (Tube) -> spot, scale, aspect -> scan lines ->
/// sRGB bytes, the nearest, clipped where sRGB does not have the colour. Everything before the
/// bytes is in light in proportion to its energy, in double precision and in a fixed order: the
/// same bytes each time.
///
/// - spot: a Gaussian across and down; beyond the picture's edges it goes on with its last pixels,
///   so that an even area stays as it is.
/// - aspect: across, each output pixel takes the mean over its place (eltek/light_shares.h).
/// - scan lines: the k-th of the `scale` rows of a line is multiplied by
///   1 - depth (1 + cos(2 pi (k + 1/2) / scale)) / 2, whose mean is 1 - depth / 2.
///
/// Copies are cheap. Safe for several threads.
class Crt {
 public:
  /// Throws std::invalid_argument for options that are not valid.
  explicit Crt(const CrtOptions& options = {});

  const CrtOptions& options() const { return options_; }
  const Tube& tube() const { return tube_; }

  /// The 256 entries by the tube alone: for live display, of this screen and of any with the same
  /// entries. `seen` are the bytes of an ideal monitor behind such a DAC (IndexedScreen::palette),
  /// which tell the codes.
  std::array<Rgb8, 256> palette(std::span<const Rgb8, 256> seen, const quant::DacBits& dac) const;
  std::array<Rgb8, 256> palette(const IndexedScreen& screen) const {
    return palette(screen.palette, screen.dac);
  }

  /// The size that a picture is shown in: the larger by `scale` and, where it was asked for, 65:64
  /// wide, to the nearest pixel.
  ImageSize shown_size(ImageSize picture) const;

  /// The picture with everything that the options say.
  Screen show(const IndexedScreen& screen) const;

  /// The same of colours that come from no LUT (a true-colour reference): a byte's voltage is
  /// byte / 255.
  Screen show(const Screen& screen) const;

 private:
  Screen bytes_of(ImageSize size, const std::vector<quant::Light>& light) const;

  CrtOptions options_;
  Tube tube_;
};

}  // namespace sir::eltek
