// From pixels to LUT indices: the nearest entry as seen (thesis 3.5).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quant/index_set.h"
#include "quant/lut.h"
#include "tracer/planes.h"

namespace sir::quant {

/// The definition: the index with the least squared distance between the
/// colour's bytes and the entry's bytes as seen; ties take the lowest index.
/// All 256 entries are compared but those `reserved`, which no colour takes,
/// not even their own. Here and below std::invalid_argument where all are.
std::uint8_t nearest_entry(Rgb8 colour, const Lut& lut, const IndexSet& reserved = {});

/// How pixels are mapped. The thesis and all of SIR take the nearest entry; the
/// other is there to price it.
enum class Mapping : std::uint8_t {
  exact,       ///< nearest_entry() on every pixel
  approximate  ///< InverseMap: a colour takes the entry of its cell of the lattice
};

/// The image as LUT indices, one a pixel, rows from the top. With Mapping::exact
/// equal to nearest_entry on every pixel, but faster (NearestSearch).
std::vector<std::uint8_t> map_to_lut(const Planes& image, const Lut& lut,
                                     Mapping mapping = Mapping::exact,
                                     const IndexSet& reserved = {});

/// The same by the definition, pixel by pixel: a comparison with every entry each.
std::vector<std::uint8_t> map_exhaustively(const Planes& image, const Lut& lut,
                                           const IndexSet& reserved = {});

/// Finds nearest entries among few candidates. The colours are divided into cubes, those
/// again into smaller ones. Let f be the entry nearest to a cube's centre; another entry is
/// nearest to no colour of the cube if f is nearer everywhere in it, which the difference of
/// their squared distances, being linear, shows at one corner. A cube's candidates are
/// listed when its first colour comes, out of those of the cube around it.
class NearestSearch {
 public:
  explicit NearestSearch(const Lut& lut, const IndexSet& reserved = {});

  /// The same as nearest_entry.
  std::uint8_t operator()(Rgb8 colour);

 private:
  struct Candidate {
    std::uint8_t r, g, b, index;
  };
  struct Range {
    std::uint32_t first = 0, count = 0;  // of candidates_; count 0: not listed yet
  };

  /// All cubes of 2^shift levels a side.
  struct Cubes {
    int shift;
    std::vector<Range> ranges;
    explicit Cubes(int bits);
    Range& around(Rgb8 colour);
  };

  Range listed(Rgb8 colour, std::size_t level);
  Range list(Rgb8 colour, int shift, Range from);

  Range all_;                          // neither reserved nor of a colour that stood before
  std::vector<Candidate> candidates_;  // of every range, indices ascending within each
  std::array<Cubes, 2> levels_;        // from large cubes to small ones
};

}  // namespace sir::quant
