// From pixels to LUT indices by the eye: the entry of least CIEDE2000 (see ColourMeasure).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "quant/ciede2000.h"
#include "quant/colour_measure.h"
#include "quant/index_set.h"
#include "quant/lut.h"
#include "quant/sweep_search.h"
#include "tracer/planes.h"

namespace sir::quant {

/// A square of CIEDE2000 up to which its local form is trusted. Farther away the form, which knows
/// the colour but not the entry, goes astray: for white it is as strict with chroma as CIEDE2000 is
/// among greys, so that a dark brown would be nearer than a yellow.
inline constexpr float kFormHolds = 10 * 10;

/// Of two squared differences from afar: 1.4 times as far.
inline constexpr double kOutOfQuestion = 2;

/// CIE94 (CIE 116-1995) with the geometric mean of both chromas, squared: a fraction of the time of
/// CIEDE2000, and of the same mind about which colours are out of question.
double afar(const Lab& a, const Lab& b);

/// The definition: the index with the least ColourMeasure(Goal::perceptual).difference of the
/// colour and the entry as seen. Where that is more than kFormHolds: of the entries whose afar()
/// is at most kOutOfQuestion times the least, the one with the least ciede2000(). Ties take the
/// lowest index. All entries that are not reserved are compared. Throws std::invalid_argument
/// where all are reserved.
std::uint8_t perceptually_nearest(Rgb8 colour, const Lut& lut, ColourMeasure& measure,
                                  const IndexSet& reserved = {});

/// The same, found faster. Not for use by two threads at once.
class PerceptualSearch {
 public:
  explicit PerceptualSearch(const Lut& lut, const IndexSet& reserved = {});

  std::uint8_t operator()(Rgb8 colour);

 private:
  ColourMeasure measure_;
  std::vector<Lab> labs_;              // by place in indices_
  std::vector<std::uint8_t> indices_;  // ascending, without those of a colour that stood before
  std::optional<SweepSearch> search_;
};

/// The image as LUT indices, one a pixel, rows from the top.
std::vector<std::uint8_t> map_perceptually(const Planes& image, const Lut& lut,
                                           const IndexSet& reserved = {});

}  // namespace sir::quant
