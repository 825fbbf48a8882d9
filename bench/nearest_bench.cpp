// How fast is map_to_lut against the exhaustive search of thesis 3.5?
// Usage: nearest_bench [BASE...]   (planes of 640x480; without any, made-up images)
// Runs are paired and interleaved; medians and the median of the pairs' ratios
// are printed. Exit code 1 where the two ever differ.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <random>
#include <string>
#include <vector>

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

std::uint8_t byte_of(double intensity) {
  return static_cast<std::uint8_t>(std::floor(255 * std::clamp(intensity, 0.0, 1.0) + 0.5));
}

/// Shaded balls of many hues on a plain background, like a render.
Planes balls() {
  Planes image(sir::ImageSize{640, 480});
  for (int j = 0; j < 480; ++j)
    for (int i = 0; i < 640; ++i) {
      const double x = (i % 160 - 80) / 75.0, y = (j % 160 - 80) / 75.0;
      const int ball = j / 160 * 4 + i / 160;
      const double inside = 1 - x * x - y * y;
      if (inside < 0) {
        image.set(static_cast<std::size_t>(j * 640 + i), {40, 60, 90});
        continue;
      }
      const double light = std::max(0.0, 0.6 * std::sqrt(inside) - 0.5 * x - 0.6 * y);
      const double shine = 0.6 * std::pow(light, 40);
      const auto primary = [&](int phase) {
        return byte_of((0.5 + 0.5 * std::cos(ball * 0.55 + 2.1 * phase)) * (0.15 + light) + shine);
      };
      image.set(static_cast<std::size_t>(j * 640 + i), {primary(0), primary(1), primary(2)});
    }
  return image;
}

/// The balls with the grain of a photograph.
Planes grainy() {
  Planes image = balls();
  std::mt19937 random(1989);
  for (auto& plane : image.channel)
    for (auto& byte : plane) byte = byte_of((byte + static_cast<double>(random() % 17) - 8) / 255);
  return image;
}

Planes noise() {
  Planes image(sir::ImageSize{640, 480});
  std::mt19937 random(1989);
  for (auto& plane : image.channel)
    for (auto& byte : plane) byte = static_cast<std::uint8_t>(random() >> 24);
  return image;
}

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
    pictures = {{"balls", balls()}, {"grainy balls", grainy()}, {"noise", noise()}};
  bool equal = true;
  for (const Picture& picture : pictures) equal = compare(picture) && equal;
  return equal ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "nearest_bench: %s\n", error.what());
  return 1;
}
