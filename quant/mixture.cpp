#include "quant/mixture.h"

#include <algorithm>

#include "quant/blue_noise.h"
#include "quant/colour_table.h"

namespace sir::quant {

Mixture mixture_of(Rgb8 colour, KnownEntries& entries) {
  Mixture mixture;
  const KnownEntries::Aim aim = entries.aim(colour);
  Light error{};
  for (std::uint8_t& index : mixture) {
    const auto taken = entries.take(aim, error);
    index = taken.index;
    error = taken.error;
  }
  std::sort(mixture.begin(), mixture.end(),
            [&](std::uint8_t a, std::uint8_t b) { return entries.place(a) < entries.place(b); });
  return mixture;
}

std::vector<std::uint8_t> mixed_by_place(const Planes& image, std::span<const std::uint8_t> flat,
                                         KnownEntries& entries) {
  constexpr std::uint32_t kUnknown = 0xFFFFFFFF;
  const BlueNoise& mask = BlueNoise::mask();
  const auto width = static_cast<std::size_t>(image.size.width);
  std::vector<std::uint8_t> indices(image.size.pixels());
  std::vector<Mixture> mixtures;
  ColourTable<std::uint32_t> place(kUnknown);  // of a colour's mixture among them
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const Rgb8 colour = image.at(i);
    if (flat[i]) {
      indices[i] = entries.nearest(colour);
      continue;
    }
    std::uint32_t& known = place[colour];
    if (known == kUnknown) {
      known = static_cast<std::uint32_t>(mixtures.size());
      mixtures.push_back(mixture_of(colour, entries));
    }
    const std::size_t rank = mask.rank(i % width, i / width);
    indices[i] = mixtures[known][rank * kMixed / BlueNoise::kRanks];
  }
  return indices;
}

}  // namespace sir::quant
