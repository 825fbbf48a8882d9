// The beam that scans the MA120's memory out, line after line (our model; thesis 3.4 gives what
// is scanned out, not when).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "eltek/ma120.h"
#include "eltek/raster_position.h"
#include "eltek/screen.h"

namespace sir::eltek {

/// What is on the tube is what the machine held when the beam passed. A register written while it
/// is at line n shows from line n on, so that a LUT changed in mid-frame gives bars; all changes
/// take effect between lines, none within one. It refers to the machine, which outlives it.
///
/// A line is kept as indices under the pixel mask and the palette of its moment.
class Raster {
 public:
  /// The tube is black, the beam at line 0.
  explicit Raster(const Ma120& machine);

  /// Where the beam is: position().line() comes next.
  const RasterPosition& position() const { return position_; }

  /// Scans the lines from here to before `line`, with the machine as it is now; see
  /// RasterPosition::advance_to.
  void advance_to(int line);

  /// As at power-on: the tube is black, a frame begins.
  void restart();

  /// Lines before this one, counted as position().scanned(), are not put on the tube: for one who
  /// knows that they will have been scanned again before anybody looks.
  void paint_from(std::int64_t scanned) { paint_from_ = scanned; }

  /// What is on the tube: of this frame what is above the beam, the rest of the one before.
  Screen tube() const;

  /// This frame as it would be if nothing more were written: the lines above the beam as they
  /// were scanned, the others as the machine is now.
  Screen frame() const;

  /// The same before the LUT, where all lines have one palette; nothing otherwise.
  std::optional<IndexedScreen> capture() const;

 private:
  using Palette = std::array<Rgb8, 256>;
  struct Tube {
    std::vector<std::uint8_t> indices;  // under the mask, FrameBuffer::kColumns a line
    std::array<std::shared_ptr<const Palette>, FrameBuffer::kRows> palettes;
  };

  void scan(Tube& tube, int first, int end, const std::shared_ptr<const Palette>& palette) const;
  std::shared_ptr<const Palette> palette_now() const;
  Tube finished() const;
  static Screen seen(const Tube& tube);

  const Ma120* machine_;
  RasterPosition position_;
  std::int64_t paint_from_ = 0;
  Tube tube_;
};

}  // namespace sir::eltek
