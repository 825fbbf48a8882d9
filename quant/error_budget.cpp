#include "quant/error_budget.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "quant/image_pair.h"
#include "quant/nearest.h"

namespace sir::quant {
namespace {

/// The errors of a colour after the three steps.
struct Errors {
  double unrounded = 0, rounded = 0, shown = 0;
};

Rgb as_rgb(Rgb8 colour) { return {colour.r / 255.0, colour.g / 255.0, colour.b / 255.0}; }

/// The mean over the channels of the squared difference in bytes.
double square_error(Rgb a, Rgb b) {
  const double r = a.r - b.r, g = a.g - b.g, blue = a.b - b.b;
  return (r * r + g * g + blue * blue) * (255.0 * 255.0 / 3);
}

std::vector<Rgb> seen_colours(const Lut& lut) {
  std::vector<Rgb> colours;
  for (std::size_t i = 0; i < lut.chosen; ++i) colours.push_back(as_rgb(lut.seen(i)));
  return colours;
}

/// Averages errors_of(colour, as shown) over the pixels.
template <typename ErrorsOf>
ErrorBudget budget(const Planes& reference, const Lut& lut, std::span<const Rgb> unrounded,
                   ErrorsOf errors_of) {
  if (reference.size.pixels() == 0) throw std::invalid_argument("an image without pixels");
  if (unrounded.empty()) throw std::invalid_argument("no unrounded colours");
  NearestSearch search(lut);
  Errors sum;
  for (const auto& [colour, count] : distinct_colours(reference)) {
    const Errors errors = errors_of(colour, lut.seen(search(colour)));
    const auto pixels = static_cast<double>(count);
    sum.unrounded += pixels * errors.unrounded;
    sum.rounded += pixels * errors.rounded;
    sum.shown += pixels * errors.shown;
  }
  const auto pixels = static_cast<double>(reference.size.pixels());
  return {sum.shown / pixels, sum.unrounded / pixels, (sum.rounded - sum.unrounded) / pixels,
          (sum.shown - sum.rounded) / pixels};
}

std::vector<Lab> labs_of(std::span<const Rgb> colours) {
  std::vector<Lab> labs;
  for (const Rgb& colour : colours) labs.push_back(lab_of(colour));
  return labs;
}

double least_square(Rgb colour, std::span<const Rgb> colours) {
  double least = std::numeric_limits<double>::infinity();
  for (const Rgb& other : colours) least = std::min(least, square_error(colour, other));
  return least;
}

/// The greatest weight S_L of a difference in lightness between black and
/// white: 1 + 0.015 * 50^2 / sqrt(20 + 50^2) = 1.74702.
constexpr double kGreatestWeightOfL = 1.7471;

/// No more than CIEDE2000, and quicker to have. With x and y the weighted
/// differences in chroma and hue, the formula's x^2 + y^2 + R_T x y is at least
/// (1 - |R_T| / 2) (x^2 + y^2), and |R_T| is below 2 sin 60 degrees. The weight
/// of the hue, whose T is below 2, does not exceed that of the chroma; stretching
/// a by up to 1.5 makes no difference smaller and no chroma more than 1.5 times as large.
double least_possible(const Lab& a, const Lab& b) {
  constexpr double kShare = 0.1339;  // 1 - sin 60 degrees = 0.13397
  const double chromas = std::sqrt(a.a * a.a + a.b * a.b) + std::sqrt(b.a * b.a + b.b * b.b);
  const double weight = 1 + 0.045 * 1.5 * chromas / 2;
  const double l = (a.l - b.l) / kGreatestWeightOfL;
  const double x = (a.a - b.a) / weight, y = (a.b - b.b) / weight;
  return std::sqrt(l * l + kShare * (x * x + y * y)) * (1 - 1e-12);
}

/// The colour of a primary nearest to `wanted` that is rounded to the code out of 0 to `most`.
double nearest_before_rounding(double wanted, int code, int most) {
  const double low = std::max((code - 0.5) / most, 0.0);
  const double high = std::min((code + 0.5) / most, 1.0);
  return std::clamp(wanted, low, high);
}

}  // namespace

LeastDifference::LeastDifference(std::vector<Lab> colours) : by_lightness_(std::move(colours)) {
  std::sort(by_lightness_.begin(), by_lightness_.end(),
            [](const Lab& a, const Lab& b) { return a.l < b.l; });
}

double LeastDifference::operator()(const Lab& colour) const {
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const Lab& other) {
    if (least_possible(colour, other) < least) least = std::min(least, ciede2000(colour, other));
  };
  const auto too_far = [&](const Lab& other) {
    return std::abs(other.l - colour.l) > least * kGreatestWeightOfL;
  };
  // From the entries of the same lightness up and down in turn.
  const auto first = by_lightness_.begin(), end = by_lightness_.end();
  auto up = std::lower_bound(first, end, colour.l,
                             [](const Lab& entry, double l) { return entry.l < l; });
  auto down = up;
  while (up != end || down != first) {
    if (up != end) {
      if (too_far(*up)) up = end;
      else consider(*up++);
    }
    if (down != first) {
      if (too_far(*std::prev(down))) down = first;
      else consider(*--down);
    }
  }
  return least;
}

ErrorBudget error_budget(const Planes& reference, const Lut& lut, std::span<const Rgb> unrounded) {
  const LeastDifference of_unrounded(labs_of(unrounded)), of_rounded(labs_of(seen_colours(lut)));
  return budget(reference, lut, unrounded, [&](Rgb8 colour, Rgb8 shown) {
    const Lab lab = lab_of(colour);
    return Errors{of_unrounded(lab), of_rounded(lab), ciede2000(lab, lab_of(shown))};
  });
}

ErrorBudget error_budget(const Planes& reference, const Lut& lut) {
  return error_budget(reference, lut, unrounded_colours(reference, lut));
}

ErrorBudget square_error_budget(const Planes& reference, const Lut& lut,
                                std::span<const Rgb> unrounded) {
  return budget(reference, lut, unrounded, [&](Rgb8 colour, Rgb8 shown) {
    const double error = square_error(as_rgb(colour), as_rgb(shown));
    return Errors{least_square(as_rgb(colour), unrounded), error, error};
  });
}

ErrorBudget square_error_budget(const Planes& reference, const Lut& lut) {
  return square_error_budget(reference, lut, unrounded_colours(reference, lut));
}

std::vector<Rgb> unrounded_colours(const Planes& reference, const Lut& lut) {
  struct Sum {
    std::array<std::uint64_t, 3> bytes{};
    std::uint64_t pixels = 0;
  };
  std::array<Sum, kLutEntries> sums{};
  const auto indices = map_to_lut(reference, lut);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    Sum& sum = sums[indices[i]];
    for (std::size_t c = 0; c < 3; ++c) sum.bytes[c] += reference.channel[c][i];
    ++sum.pixels;
  }
  std::vector<Rgb> colours;
  std::set<DacCode> known;
  for (std::size_t i = 0; i < lut.chosen; ++i) {
    const DacCode& code = lut.entry[i];
    if (!known.insert(code).second) continue;
    const auto primary = [&](std::size_t c) {
      const Sum& sum = sums[i];
      const int most = lut.dac.max_code(c);
      if (sum.pixels == 0) return static_cast<double>(code[c]) / most;
      return nearest_before_rounding(
          static_cast<double>(sum.bytes[c]) / (255 * static_cast<double>(sum.pixels)), code[c],
          most);
    };
    colours.push_back({primary(0), primary(1), primary(2)});
  }
  return colours;
}

}  // namespace sir::quant
