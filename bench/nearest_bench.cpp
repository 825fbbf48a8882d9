// How fast is map_to_lut against the exhaustive search of thesis 3.5?
// Usage: nearest_bench [BASE...]   (planes of 640x480; without any, made-up images)
// Runs are paired and interleaved; medians and the median of the pairs' ratios
// are printed. Exit code 1 where the two ever differ.
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "bench/made_up.h"
#include "bench/timing.h"
#include "quant/choose.h"
#include "quant/nearest.h"
#include "tracer/planes.h"

namespace {

using sir::Planes;
using sir::bench::median;
using sir::bench::milliseconds;
using sir::quant::Lut;

constexpr int kPairs = 15;

struct Picture {
  std::string name;
  Planes planes;
};

/// False where the two searches disagree.
bool compare(const Picture& picture) {
  const Lut lut = sir::quant::choose_lut(picture.planes);
  std::vector<double> plain, fast, ratio;
  bool equal = true;
  for (int pair = 0; pair < kPairs; ++pair) {
    std::vector<std::uint8_t> a, b;
    plain.push_back(milliseconds([&] { a = sir::quant::map_exhaustively(picture.planes, lut); }));
    fast.push_back(milliseconds([&] { b = sir::quant::map_to_lut(picture.planes, lut); }));
    ratio.push_back(plain.back() / fast.back());
    equal = equal && a == b;
  }
  std::printf("%-16s exhaustive %8.2f ms   fast %7.2f ms   ratio %6.1f%s\n", picture.name.c_str(),
              median(plain), median(fast), median(ratio), equal ? "" : "   DIFFERENT");
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
  for (const Picture& picture : pictures) equal = compare(picture) && equal;
  return equal ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "nearest_bench: %s\n", error.what());
  return 1;
}
