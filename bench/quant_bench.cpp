// What does choosing a LUT cost, by each of the thesis's four methods?
// Usage: quant_bench [BASE...]   (planes of 640x480; without any, made-up images)
// The methods take turns within each round; medians of the rounds are printed
// for counting and choosing, and the median ratio to median cut in RGB.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <random>
#include <string>
#include <vector>

#include "bench/timing.h"
#include "quant/choose.h"
#include "tracer/planes.h"

namespace {

using sir::bench::median;
using sir::bench::milliseconds;
using namespace sir::quant;
using sir::Planes;

const int kRounds = sir::bench::rounds(31);

struct Contender {
  const char* name;
  ChooseOptions options;
};

ChooseOptions method(Method which, Space space, SplitOrder split = SplitOrder::pixels) {
  ChooseOptions options;
  options.method = which;
  options.space = space;
  options.split = split;
  return options;
}

const std::array<Contender, 6> kContenders{{
    {"median rgb", method(Method::median, Space::rgb)},
    {"median hsv", method(Method::median, Space::hsv)},
    {"frequency rgb", method(Method::frequency, Space::rgb)},
    {"frequency hsv", method(Method::frequency, Space::hsv)},
    {"median rgb, breadth", method(Method::median, Space::rgb, SplitOrder::breadth)},
    {"median rgb, longest", method(Method::median, Space::rgb, SplitOrder::longest)},
}};

struct Times {
  std::vector<double> count, choose, ratio;
};

/// Soft gradients of all hues; `grain` levels of noise on top.
Planes gradients(unsigned grain) {
  Planes image(sir::ImageSize{640, 480});
  std::mt19937 random(1989);
  for (int j = 0; j < 480; ++j)
    for (int i = 0; i < 640; ++i) {
      const auto primary = [&](double phase) {
        const double wave = 0.5 + 0.5 * std::cos(i * 0.009 + phase);
        const double level = 235 * wave * (0.2 + 0.8 * j / 479.0);
        const auto noise = static_cast<int>(random() % (grain + 1));
        return static_cast<std::uint8_t>(static_cast<int>(level) + noise);
      };
      image.set(static_cast<std::size_t>(j * 640 + i), {primary(0), primary(2.1), primary(4.2)});
    }
  return image;
}

void compare(const std::string& name, const Planes& image) {
  std::array<Times, kContenders.size()> times;
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < kContenders.size(); ++i) {
      const ChooseOptions& options = kContenders[i].options;
      Histogram cells;
      times[i].count.push_back(milliseconds([&] { cells = count_for(image, options); }));
      times[i].choose.push_back(milliseconds([&] { (void)choose_from(cells, options); }));
      times[i].ratio.push_back((times[i].count.back() + times[i].choose.back()) /
                               (times[0].count.back() + times[0].choose.back()));
    }
  const CellCounts cells = occupied_cells(image);
  std::printf("%s: %zu RGB cells, %zu HSV cells\n", name.c_str(), cells.rgb, cells.hsv);
  for (std::size_t i = 0; i < kContenders.size(); ++i)
    std::printf("  %-20s count %6.3f ms   choose %6.3f ms   ratio %5.2f\n", kContenders[i].name,
                median(times[i].count), median(times[i].choose), median(times[i].ratio));
}

}  // namespace

int main(int count, char** arguments) try {
  for (int i = 1; i < count; ++i)
    compare(arguments[i], sir::read_planes(arguments[i], sir::ImageSize{}));
  if (count == 1) {
    compare("gradients", gradients(0));
    compare("grainy gradients", gradients(20));
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "quant_bench: %s\n", error.what());
  return 1;
}
