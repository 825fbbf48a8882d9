// From pixels to LUT indices: the nearest entry as seen (thesis 3.5).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quant/lut.h"
#include "tracer/planes.h"

namespace sir::quant {

/// The definition: the index with the least squared distance between the
/// colour's bytes and the entry's bytes as seen; ties take the lowest index.
/// All 256 entries are compared.
std::uint8_t nearest_entry(Rgb8 colour, const Lut& lut);

/// The image as LUT indices, one a pixel, rows from the top. Equal to
/// nearest_entry on every pixel, but faster (NearestSearch).
std::vector<std::uint8_t> map_to_lut(const Planes& image, const Lut& lut);

/// The same by the definition, pixel by pixel: 256 comparisons each.
std::vector<std::uint8_t> map_exhaustively(const Planes& image, const Lut& lut);

/// Finds nearest entries among few candidates. The colours are divided into
/// cubes. An entry can be nearest to a colour of a cube only if its least
/// distance to the cube does not exceed the greatest distance of some other
/// entry; a cube's candidates are listed when its first colour comes.
class NearestSearch {
 public:
  explicit NearestSearch(const Lut& lut);

  /// The same as nearest_entry.
  std::uint8_t operator()(Rgb8 colour);

 private:
  static constexpr int kShift = 4;  // cubes of 16 levels a side
  static constexpr int kSide = 256 >> kShift;

  struct Candidate {
    std::int16_t r, g, b;
    std::uint8_t index;
  };
  struct Range {
    std::uint32_t first = 0, count = 0;  // count 0: not listed yet
  };

  void list_candidates(Rgb8 colour, Range& range);

  std::vector<Candidate> entries_;     // without colours that stood before
  std::vector<Candidate> candidates_;  // of all listed cubes, indices ascending within each
  std::array<Range, std::size_t{kSide} * kSide * kSide> cubes_{};
};

}  // namespace sir::quant
