#include "tracer/sample_random.h"

#include <algorithm>
#include <cmath>

namespace sir {
namespace {

std::uint64_t splitmix64(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

// Where the permutation `which` of 0..length-1 takes `index` (Kensler 2013, listing 3):
// a hash that is invertible on the next power of two, repeated until it falls inside.
std::uint32_t permuted(std::uint32_t index, std::uint32_t length, std::uint32_t which) {
  std::uint32_t mask = length - 1;
  for (int shift = 1; shift < 32; shift *= 2) mask |= mask >> shift;
  do {
    index ^= which;
    index *= 0xe170893d;
    index ^= which >> 16;
    index ^= (index & mask) >> 4;
    index ^= which >> 8;
    index *= 0x0929eb3f;
    index ^= which >> 23;
    index ^= (index & mask) >> 1;
    index *= 1 | which >> 27;
    index *= 0x6935fa69;
    index ^= (index & mask) >> 11;
    index *= 0x74dcb303;
    index ^= (index & mask) >> 2;
    index *= 0x9e501cc3;
    index ^= (index & mask) >> 2;
    index *= 0xc860a3df;
    index &= mask;
    index ^= index >> 5;
  } while (index >= length);
  return (index + which % length) % length;
}

}  // namespace

ScreenPoint scattered_point(std::uint64_t seed, int i, int j, int sample, int samples) {
  const auto count = static_cast<std::uint32_t>(samples), s = static_cast<std::uint32_t>(sample);
  const auto m = static_cast<std::uint32_t>(std::sqrt(samples));
  const std::uint32_t n = (count + m - 1) / m;
  const auto place = std::uint64_t{static_cast<std::uint32_t>(i)} << 32 |
                     std::uint64_t{static_cast<std::uint32_t>(j)};
  const std::uint64_t pixel = splitmix64(splitmix64(seed) ^ place);
  const std::uint64_t jitter = splitmix64(pixel + s);
  const double jitter_x = double(jitter >> 32) * 0x1p-32;
  const double jitter_y = double(jitter & 0xffffffff) * 0x1p-32;
  // The cell's column, and which of the column's n strips holds the point.
  const std::uint32_t column = permuted(s % m, m, static_cast<std::uint32_t>(pixel >> 32));
  const std::uint32_t strip = permuted(s / m, n, static_cast<std::uint32_t>(pixel));
  return {i + (column + (strip + jitter_x) / n) / m, j + (s + jitter_y) / count};
}

bool sample_random(const Region& region, const AntialiasOptions& options,
                   const SampleSource& source, Planes& planes, AntialiasCounts& counts,
                   const PixelKeeping& keeping) {
  planes = Planes(ImageSize{region.width, region.height});
  const auto samples = static_cast<std::size_t>(options.samples);
  const auto width = static_cast<std::size_t>(region.width);
  const std::size_t pixels = planes.size.pixels();
  // At a time: enough for many threads, few enough to be done soon, for who keeps them.
  constexpr std::size_t kPoints = 1 << 16;
  const std::size_t batch = std::max<std::size_t>(kPoints / samples, 1);
  std::vector<ScreenPoint> points;
  std::vector<Rgb8> seen, means;
  // The means of a batch, from its samples.
  const auto trace = [&](std::size_t begin) {
    const std::size_t end = begin + means.size();
    points.clear();
    for (std::size_t p = begin; p < end; ++p)
      for (int s = 0; s < options.samples; ++s)
        points.push_back(scattered_point(options.seed, region.x + static_cast<int>(p % width),
                                         region.y + static_cast<int>(p / width), s,
                                         options.samples));
    seen.resize(points.size());
    if (!source(points, seen, {double(begin) / double(pixels), double(end) / double(pixels)}))
      return false;
    for (std::size_t p = 0; p < means.size(); ++p) {
      std::size_t r = 0, g = 0, b = 0;
      for (std::size_t s = p * samples; s < (p + 1) * samples; ++s) {
        r += seen[s].r;
        g += seen[s].g;
        b += seen[s].b;
      }
      const auto mean = [&](std::size_t sum) {
        return static_cast<std::uint8_t>((2 * sum + samples) / (2 * samples));
      };
      means[p] = {mean(r), mean(g), mean(b)};
    }
    return true;
  };
  for (std::size_t begin = 0; begin < pixels; begin += batch) {
    means.resize(std::min(batch, pixels - begin));
    if (!keeping.keeper) {
      if (!trace(begin)) return false;
    } else if (!keeping.keeper->take({keeping.stage, begin}, means)) {
      const RayCounts before = keeping.counts();
      if (!trace(begin)) return false;
      keeping.keeper->keep({keeping.stage, begin}, means, keeping.counts().since(before));
    }
    counts.points += means.size() * samples;
    for (std::size_t p = 0; p < means.size(); ++p) planes.set(begin + p, means[p]);
  }
  return true;
}

}  // namespace sir
