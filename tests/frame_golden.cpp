#include "tests/frame_golden.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "eltek/screen_hash.h"
#include "viewer/png_file.h"

namespace sir::test {
namespace {

using Colour = std::array<int, 3>;

Colour seen(const quant::DacCode& entry) {
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] = static_cast<int>(std::floor(255.0 * entry[i] / 63 + 0.5));
  return colour;
}

Rgb8 nearest(const Colour& wanted, const quant::Lut& lut) {
  int least = 1 << 30;
  Colour best{};
  for (const quant::DacCode& entry : lut.entry) {
    const Colour colour = seen(entry);
    int distance = 0;
    for (std::size_t i = 0; i < 3; ++i)
      distance += (colour[i] - wanted[i]) * (colour[i] - wanted[i]);
    if (distance >= least) continue;
    least = distance;
    best = colour;
  }
  return {static_cast<std::uint8_t>(best[0]), static_cast<std::uint8_t>(best[1]),
          static_cast<std::uint8_t>(best[2])};
}

int difference(Rgb8 a, Rgb8 b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

// How the screen compares with the definitions; draws the difference.
std::string compare(const eltek::Screen& actual, const eltek::Screen& plain, eltek::Screen& diff) {
  std::size_t count = 0, first = 0;
  for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
    const int most = difference(actual.pixels[i], plain.pixels[i]);
    if (most == 0) continue;
    if (count++ == 0) first = i;
    const auto grey = static_cast<std::uint8_t>(std::min(255, 95 + most));  // 1 is to be seen too
    diff.pixels[i] = {grey, grey, grey};
  }
  if (count == 0)
    return "From these planes and this LUT the screen is what the definitions say:\n"
           "the search, the registers and the scanout are right.\n";
  const Rgb8 is = actual.pixels[first], should = plain.pixels[first];
  return fmt::format(
      "By the definitions {} pixels should be others; the first, in column {} and row {}, is\n"
      "{},{},{} and should be {},{},{}: the search, the registers or the scanout are wrong.\n",
      count, first % 1024, first / 1024, is.r, is.g, is.b, should.r, should.g, should.b);
}

}  // namespace

FrameHashes hashes(const Frame& frame) {
  std::vector<std::uint8_t> planes, lut;
  for (const auto& channel : frame.planes.channel)
    planes.insert(planes.end(), channel.begin(), channel.end());
  for (const auto& entry : frame.lut.entry) lut.insert(lut.end(), entry.begin(), entry.end());
  return {eltek::hash(planes), eltek::hash(lut), eltek::hash(frame.indices),
          eltek::hash(frame.screen)};
}

std::string row(const std::string& name, const FrameHashes& h) {
  return fmt::format("{{\"{}\", {{0x{:016X}u, 0x{:016X}u, 0x{:016X}u, 0x{:016X}u}}}},", name,
                     h.planes, h.lut, h.indices, h.screen);
}

eltek::Screen plain_screen(const Planes& planes, const quant::Lut& lut) {
  constexpr int kWidth = 1024, kHeight = 780;
  eltek::Screen screen{{kWidth, kHeight}, {}};
  screen.pixels.assign(std::size_t{kWidth} * kHeight, nearest({0, 0, 0}, lut));
  const int left = (kWidth - planes.size.width) / 2, top = (kHeight - planes.size.height) / 2;
  std::map<Colour, Rgb8> known;
  for (int j = 0; j < planes.size.height; ++j)
    for (int i = 0; i < planes.size.width; ++i) {
      const auto p = static_cast<std::size_t>(j * planes.size.width + i);
      const Colour wanted{planes.channel[0][p], planes.channel[1][p], planes.channel[2][p]};
      const auto [place, is_new] = known.try_emplace(wanted);
      if (is_new) place->second = nearest(wanted, lut);
      screen.pixels[static_cast<std::size_t>((top + j) * kWidth + left + i)] = place->second;
    }
  return screen;
}

std::string judge(const Frame& frame, const FrameHashes& golden,
                  const std::filesystem::path& folder) {
  const FrameHashes now = hashes(frame);
  if (now == golden) return {};
  std::string text = frame.name + " is no longer the frame that it was:\n";
  const char* first = nullptr;
  using Stage = std::tuple<const char*, std::uint64_t, std::uint64_t>;
  for (const auto& [stage, is, was] :
       {Stage{"planes (tracer/)", now.planes, golden.planes},
        Stage{"LUT (quant/, choice)", now.lut, golden.lut},
        Stage{"indices (quant/, search)", now.indices, golden.indices},
        Stage{"screen (eltek/)", now.screen, golden.screen}}) {
    if (is != was && first == nullptr) first = stage;
    text += fmt::format("  {:26}{:016X}{}\n", stage, is,
                        is == was ? ", as ever" : fmt::format(", was {:016X}", was));
  }
  text += fmt::format("The first stage to depart: {}.\n", first);

  const eltek::Screen plain = plain_screen(frame.planes, frame.lut);
  eltek::Screen diff{plain.size, std::vector<Rgb8>(plain.pixels.size())};
  text += compare(frame.screen, plain, diff);
  std::filesystem::create_directories(folder);
  const auto write = [&](const char* which, const eltek::Screen& screen) {
    viewer::write_rgb_png(folder / (frame.name + "-" + which + ".png"), eltek::to_planes(screen));
  };
  write("ACTUAL", frame.screen);
  write("PLAIN", plain);
  write("DIFF", diff);
  text +=
      fmt::format("Look at {0}/{1}-ACTUAL.png, -PLAIN.png (by the definitions) and -DIFF.png.\n",
                  folder.string(), frame.name);
  return text + "If the change is meant, this is the new row:\n  " + row(frame.name, now) + "\n";
}

}  // namespace sir::test
