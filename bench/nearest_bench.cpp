// How fast is map_to_lut against the exhaustive search of thesis 3.5, and what would the
// approximate map (Mapping::approximate) save and lose?
// Usage: nearest_bench [BASE...]   (planes of 640x480; without any, made-up images)
// Runs are paired and interleaved; medians and the median of the pairs' ratios
// are printed. Exit code 1 where the two exact ones ever differ.
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "bench/made_up.h"
#include "bench/timing.h"
#include "quant/best.h"
#include "quant/choose.h"
#include "quant/nearest.h"
#include "quant/perceptual_search.h"
#include "quant/psnr.h"
#include "quant/shown_through.h"
#include "tracer/planes.h"

namespace {

using sir::Planes;
using sir::bench::median;
using sir::bench::milliseconds;
using sir::quant::Lut;
using sir::quant::Mapping;

const int kPairs = sir::bench::rounds(15);

struct Picture {
  std::string name;
  Planes planes;
};

/// False where the two searches disagree.
bool compare(const Picture& picture) {
  const Lut lut = sir::quant::choose_lut(picture.planes);
  std::vector<double> plain, fast, ratio, rough, rough_ratio;
  std::vector<std::uint8_t> approximate;
  bool equal = true;
  for (int pair = 0; pair < kPairs; ++pair) {
    std::vector<std::uint8_t> a, b;
    plain.push_back(milliseconds([&] { a = sir::quant::map_exhaustively(picture.planes, lut); }));
    fast.push_back(milliseconds([&] { b = sir::quant::map_to_lut(picture.planes, lut); }));
    ratio.push_back(plain.back() / fast.back());
    rough.push_back(milliseconds(
        [&] { approximate = sir::quant::map_to_lut(picture.planes, lut, Mapping::approximate); }));
    rough_ratio.push_back(fast.back() / rough.back());
    equal = equal && a == b;
  }
  std::printf("%-16s exhaustive %8.2f ms   fast %7.2f ms   ratio %6.1f%s\n", picture.name.c_str(),
              median(plain), median(fast), median(ratio), equal ? "" : "   DIFFERENT");

  const Planes exact_shown = sir::quant::shown_through(picture.planes, lut);
  const Planes rough_shown = sir::quant::shown_through(picture.planes, lut, Mapping::approximate);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < approximate.size(); ++i)
    wrong += exact_shown.at(i) != rough_shown.at(i);
  const double mse = sir::quant::mean_square_error(picture.planes, exact_shown);
  const double rough_mse = sir::quant::mean_square_error(picture.planes, rough_shown);
  std::printf(
      "%-16s approximate %7.2f ms, fast/approximate %5.2f; other colours %6.3f %%, "
      "MSE %.4f -> %.4f (+%.2f %%)\n",
      "", median(rough), median(rough_ratio),
      100.0 * static_cast<double>(wrong) / static_cast<double>(approximate.size()), mse, rough_mse,
      mse > 0 ? 100 * (rough_mse / mse - 1) : 0.0);
  return equal;
}

/// The same by the eye; a few pairs, as the definition takes seconds.
bool compare_by_eye(const Picture& picture) {
  const int kFewPairs = sir::bench::rounds(3);
  sir::quant::WeightedColours colours;
  colours.add(picture.planes);
  const Lut lut = sir::quant::choose_best(colours).lut;
  std::vector<double> plain, fast, ratio;
  bool equal = true;
  for (int pair = 0; pair < kFewPairs; ++pair) {
    std::vector<std::uint8_t> a(picture.planes.size.pixels()), b;
    sir::quant::ColourMeasure measure(sir::quant::Goal::perceptual);
    plain.push_back(milliseconds([&] {
      for (std::size_t i = 0; i < a.size(); ++i)
        a[i] = sir::quant::perceptually_nearest(picture.planes.at(i), lut, measure);
    }));
    fast.push_back(milliseconds([&] { b = sir::quant::map_perceptually(picture.planes, lut); }));
    ratio.push_back(plain.back() / fast.back());
    equal = equal && a == b;
  }
  std::printf("%-16s by the eye %8.2f ms   fast %7.2f ms   ratio %6.1f%s\n", "", median(plain),
              median(fast), median(ratio), equal ? "" : "   DIFFERENT");
  return equal;
}

}  // namespace

int main(int count, char** arguments) try {
  std::vector<Picture> pictures;
  for (int i = 1; i < count; ++i)
    pictures.push_back({arguments[i], sir::read_planes(arguments[i], sir::ImageSize{})});
  if (pictures.empty())
    pictures = {{"balls", sir::bench::balls()},
                {"grainy balls", sir::bench::grainy_balls()},
                {"noise", sir::bench::noise()}};
  bool equal = true;
  for (const Picture& picture : pictures)
    equal = compare(picture) && compare_by_eye(picture) && equal;
  return equal ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "nearest_bench: %s\n", error.what());
  return 1;
}
