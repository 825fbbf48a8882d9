// From pixels to LUT indices by the eye: the entry of least CIEDE2000 (see ColourMeasure).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

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

/// The definition: the index with the least ColourMeasure(Goal::perceptual).difference of the
/// colour and the entry as seen; where that is more than kFormHolds, the one with the least
/// ciede2000(). Ties take the lowest index. All entries that are not reserved are compared. Throws
/// std::invalid_argument where all are reserved.
std::uint8_t perceptually_nearest(Rgb8 colour, const Lut& lut, ColourMeasure& measure,
                                  const IndexSet& reserved = {});

/// The same, found faster. Not for use by two threads at once.
class PerceptualSearch {
 public:
  explicit PerceptualSearch(const Lut& lut, const IndexSet& reserved = {});

  std::uint8_t operator()(Rgb8 colour) {
    const auto found = search_->nearest(measure_.point_of(colour), measure_.form_of(colour));
    return indices_[found.difference > kFormHolds ? from_afar(colour) : found.index];
  }

 private:
  std::size_t from_afar(Rgb8 colour) const;

  ColourMeasure measure_;
  std::vector<Lab> labs_;              // by place in indices_
  std::vector<std::uint8_t> indices_;  // ascending, without those of a colour that stood before
  std::optional<SweepSearch> search_;
};

/// The image as LUT indices, one a pixel, rows from the top.
std::vector<std::uint8_t> map_perceptually(const Planes& image, const Lut& lut,
                                           const IndexSet& reserved = {});

}  // namespace sir::quant
