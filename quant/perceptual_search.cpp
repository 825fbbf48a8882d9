#include "quant/perceptual_search.h"

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "quant/image_pair.h"

namespace sir::quant {
namespace {

void require_any(const IndexSet& reserved) {
  if (reserved.all()) throw std::invalid_argument("all entries are reserved");
}

}  // namespace

std::uint8_t perceptually_nearest(Rgb8 colour, const Lut& lut, ColourMeasure& measure,
                                  const IndexSet& reserved) {
  require_any(reserved);
  float least = std::numeric_limits<float>::infinity();
  std::size_t found = 0;
  for (std::size_t i = 0; i < kLutEntries; ++i) {
    if (reserved[i]) continue;
    if (const float one = measure.difference(colour, lut.seen(i)); one < least) {
      least = one;
      found = i;
    }
  }
  if (least <= kFormHolds) return static_cast<std::uint8_t>(found);
  const Lab own = lab_of(colour);
  double afar = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kLutEntries; ++i) {
    if (reserved[i]) continue;
    if (const double one = ciede2000(own, lab_of(lut.seen(i))); one < afar) {
      afar = one;
      found = i;
    }
  }
  return static_cast<std::uint8_t>(found);
}

PerceptualSearch::PerceptualSearch(const Lut& lut, const IndexSet& reserved)
    : measure_(Goal::perceptual) {
  require_any(reserved);
  std::vector<glm::vec3> points;
  std::set<std::uint32_t> known;
  for (std::size_t i = 0; i < kLutEntries; ++i) {
    if (reserved[i] || !known.insert(packed(lut.seen(i))).second) continue;
    points.push_back(measure_.point_of(lut.seen(i)));
    labs_.push_back(lab_of(lut.seen(i)));
    indices_.push_back(static_cast<std::uint8_t>(i));
  }
  search_.emplace(points);
}

// A colour differs by its lightness at least, which CIEDE2000 divides by 1.747 at most (S_L at
// black and white): most entries need no more than that.
std::size_t PerceptualSearch::from_afar(Rgb8 colour) const {
  constexpr double kMostDivided = 1.75;
  const Lab own = lab_of(colour);
  double least = std::numeric_limits<double>::infinity();
  std::size_t found = 0;
  for (std::size_t place = 0; place < labs_.size(); ++place) {
    if (std::abs(own.l - labs_[place].l) >= kMostDivided * least) continue;
    if (const double one = ciede2000(own, labs_[place]); one < least) {
      least = one;
      found = place;
    }
  }
  return found;
}

std::vector<std::uint8_t> map_perceptually(const Planes& image, const Lut& lut,
                                           const IndexSet& reserved) {
  PerceptualSearch search(lut, reserved);
  constexpr int kBits = 16;  // answers remembered, one for each hash of a colour
  struct Known {
    std::uint32_t colour = 0xFFFFFFFF;
    std::uint8_t index = 0;
  };
  std::vector<Known> known(std::size_t{1} << kBits);
  std::vector<std::uint8_t> indices(image.size.pixels());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const Rgb8 colour = image.at(i);
    const std::uint32_t key = packed(colour);
    Known& slot = known[key * 0x9E3779B1u >> (32 - kBits)];
    if (slot.colour != key) slot = {key, search(colour)};
    indices[i] = slot.index;
  }
  return indices;
}

}  // namespace sir::quant
