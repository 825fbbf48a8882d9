#include "quant/perceptual_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>

#include "quant/colour_memory.h"
#include "quant/image_pair.h"

namespace sir::quant {
namespace {

void require_any(const IndexSet& reserved) {
  if (reserved.all()) throw std::invalid_argument("all entries are reserved");
}

// The place of the entry that is nearest to a colour which is far from all.
std::size_t nearest_from_afar(const Lab& own, std::span<const Lab> entries) {
  std::array<double, kLutEntries> differences;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    differences[i] = afar(own, entries[i]);
    least = std::min(least, differences[i]);
  }
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t found = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (differences[i] > kOutOfQuestion * least) continue;
    if (const double one = ciede2000(own, entries[i]); one < nearest) {
      nearest = one;
      found = i;
    }
  }
  return found;
}

}  // namespace

double afar(const Lab& a, const Lab& b) {
  const double chroma_a = std::hypot(a.a, a.b), chroma_b = std::hypot(b.a, b.b);
  const double chroma = std::sqrt(chroma_a * chroma_b);
  const double dl = a.l - b.l, dc = chroma_a - chroma_b, da = a.a - b.a, db = a.b - b.b;
  const double hue = std::max(da * da + db * db - dc * dc, 0.0);
  const double sc = 1 + 0.045 * chroma, sh = 1 + 0.015 * chroma;
  return dl * dl + dc * dc / (sc * sc) + hue / (sh * sh);
}

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
  std::vector<Lab> labs;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < kLutEntries; ++i) {
    if (reserved[i]) continue;
    labs.push_back(lab_of(lut.seen(i)));
    indices.push_back(i);
  }
  found = indices[nearest_from_afar(lab_of(colour), labs)];
  return static_cast<std::uint8_t>(found);
}

std::uint8_t PerceptualSearch::operator()(Rgb8 colour) {
  const auto found = search_->nearest(measure_.point_of(colour), measure_.form_of(colour));
  if (found.difference <= kFormHolds) return indices_[found.index];
  return indices_[nearest_from_afar(lab_of(colour), labs_)];
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

std::vector<std::uint8_t> map_perceptually(const Planes& image, const Lut& lut,
                                           const IndexSet& reserved) {
  PerceptualSearch search(lut, reserved);
  ColourMemory memory;
  std::vector<std::uint8_t> indices(image.size.pixels());
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = memory(image.at(i), search);
  return indices;
}

}  // namespace sir::quant
