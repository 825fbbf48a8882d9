#include "bench/quantizers_judge.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "quant/banding.h"
#include "quant/blurred_difference.h"
#include "quant/ciede2000.h"
#include "quant/dac_code.h"
#include "quant/image_pair.h"
#include "quant/lut.h"
#include "quant/psnr.h"
#include "quant/shown_through.h"

namespace sir::bench {
namespace {

using quant::DacCode;

/// floor(63 v / 255 + 1/2)
int code_of(int byte) { return (2 * 63 * byte + 255) / (2 * 255); }

DacCode code_of(Rgb8 colour) {
  const auto code = [](std::uint8_t byte) { return static_cast<std::uint8_t>(code_of(byte)); };
  return {code(colour.r), code(colour.g), code(colour.b)};
}

Rgb8 nearest_as_seen(Rgb8 colour) {
  constexpr int kReach = 2;
  const DacCode middle = code_of(colour);
  const quant::Lab lab = quant::lab_of(colour);
  double least = 1e9;
  Rgb8 best;
  const auto inside = [](int code) { return code >= 0 && code <= quant::kMaxCode; };
  for (int r = middle[0] - kReach; r <= middle[0] + kReach; ++r)
    for (int g = middle[1] - kReach; g <= middle[1] + kReach; ++g)
      for (int b = middle[2] - kReach; b <= middle[2] + kReach; ++b) {
        if (!inside(r) || !inside(g) || !inside(b)) continue;
        const Rgb8 seen{quant::seen_byte(r), quant::seen_byte(g), quant::seen_byte(b)};
        const double difference = quant::ciede2000(lab, quant::lab_of(seen));
        if (difference >= least) continue;
        least = difference;
        best = seen;
      }
  return best;
}

/// Each pixel by a function of its colour, called once for each colour.
template <typename Function>
Planes recoloured(const Planes& image, Function function) {
  std::unordered_map<std::uint32_t, Rgb8> known;
  Planes result(image.size);
  for (std::size_t i = 0; i < image.size.pixels(); ++i) {
    const Rgb8 colour = image.at(i);
    const auto [found, is_new] = known.try_emplace(quant::packed(colour));
    if (is_new) found->second = function(colour);
    result.set(i, found->second);
  }
  return result;
}

}  // namespace

Score judge(const Planes& reference, const Planes& shown, const std::vector<bool>& area,
            bool dithered) {
  Score score;
  score.psnr = quant::psnr(reference, shown);
  std::vector<double> differences = quant::difference_map(reference, shown);
  const std::size_t pixels = differences.size();
  score.mean =
      std::accumulate(differences.begin(), differences.end(), 0.0) / static_cast<double>(pixels);
  double sum = 0;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < area.size() && i < pixels; ++i)
    if (area[i]) {
      sum += differences[i];
      ++inside;
    }
  if (inside > 0) score.area = sum / static_cast<double>(inside);
  const auto p95 = differences.begin() + static_cast<std::ptrdiff_t>((95 * pixels + 99) / 100 - 1);
  std::nth_element(differences.begin(), p95, differences.end());
  score.p95 = *p95;
  if (dithered) {
    score.blurred = quant::blurred_difference(reference, shown);
    score.contours = quant::banding(reference, shown);
  }
  return score;
}

Planes on_the_lattice(const Planes& image) {
  return recoloured(image, [](Rgb8 colour) { return quant::seen(code_of(colour)); });
}

Planes on_the_lattice_as_seen(const Planes& image) { return recoloured(image, nearest_as_seen); }

Planes through_rounded_palette(const Planes& reference, const Planes& palette) {
  std::vector<DacCode> codes;
  for (const quant::ColourCount& one : quant::distinct_colours(palette))
    codes.push_back(code_of(one.colour));
  if (codes.size() > quant::kLutEntries)
    throw std::runtime_error("a palette of " + std::to_string(codes.size()) + " colours");
  return quant::shown_through(reference, quant::make_lut(codes));
}

std::size_t colours_of(const Planes& image) { return quant::distinct_colours(image).size(); }

}  // namespace sir::bench
