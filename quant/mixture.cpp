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
  using Numbers = ColourTable<std::uint32_t>;  // of the colours' mixtures
  constexpr std::uint32_t kNone = 0xFFFFFFFF, kToCome = 0xFFFFFFFE;
  Numbers number(kNone);
  std::vector<Rgb8> colours;
  for (std::size_t i = 0; i < image.size.pixels(); ++i) {
    if (flat[i]) continue;
    std::uint32_t& known = number[image.at(i)];
    if (known == kNone) colours.push_back(image.at(i));
    known = kToCome;
  }
  std::sort(colours.begin(), colours.end(),
            [](Rgb8 a, Rgb8 b) { return Numbers::place(a) < Numbers::place(b); });
  std::vector<Mixture> mixtures;
  mixtures.reserve(colours.size());
  for (const Rgb8 colour : colours) {
    number[colour] = static_cast<std::uint32_t>(mixtures.size());
    mixtures.push_back(mixture_of(colour, entries));
  }

  const BlueNoise& mask = BlueNoise::mask();
  const auto width = static_cast<std::size_t>(image.size.width);
  std::vector<std::uint8_t> indices(image.size.pixels());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const Rgb8 colour = image.at(i);
    const std::size_t rank = mask.rank(i % width, i / width);
    indices[i] = flat[i] ? entries.nearest(colour)
                         : mixtures[number[colour]][rank * kMixed / BlueNoise::kRanks];
  }
  return indices;
}

}  // namespace sir::quant
