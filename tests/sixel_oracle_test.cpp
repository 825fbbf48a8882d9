// Our sixels decoded by libsixel, where that is installed.
#include <gtest/gtest.h>
#include <sixel/sixel.h>
#include <stdlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <string>

#include "eltek/dac.h"
#include "quant/lattice.h"
#include "viewer/sixel.h"

namespace sir::viewer {
namespace {

using eltek::IndexedScreen;

struct Decoded {
  ImageSize size{0, 0};
  std::vector<std::uint8_t> indices;
  std::vector<Rgb8> palette;
};

Decoded decode(std::string text) {
  auto* bytes = reinterpret_cast<unsigned char*>(text.data());
  unsigned char *pixels = nullptr, *colours = nullptr;
  Decoded decoded;
  int count = 0;
  const SIXELSTATUS status =
      sixel_decode_raw(bytes, static_cast<int>(text.size()), &pixels, &decoded.size.width,
                       &decoded.size.height, &colours, &count, nullptr);
  const std::unique_ptr<unsigned char, decltype(&::free)> own_pixels(pixels, ::free),
      own_colours(colours, ::free);
  EXPECT_TRUE(SIXEL_SUCCEEDED(status)) << sixel_helper_format_error(status);
  if (SIXEL_FAILED(status)) return decoded;
  decoded.indices.assign(pixels, pixels + decoded.size.pixels());
  for (int i = 0; i < count; ++i) {
    const unsigned char* colour = colours + 3 * i;
    decoded.palette.push_back({colour[0], colour[1], colour[2]});
  }
  return decoded;
}

/// What was drawn comes back: size, every pixel's register, every used register's codes.
void expect_round_trip(const IndexedScreen& screen) {
  const Decoded decoded = decode(sixel(screen));
  ASSERT_EQ(decoded.size, screen.size);
  ASSERT_EQ(decoded.indices, screen.indices);
  const quant::Lattice lattice(screen.dac);
  for (const std::uint8_t index : screen.indices) {
    ASSERT_LT(index, decoded.palette.size());
    ASSERT_EQ(lattice.nearest(decoded.palette[index]), lattice.nearest(screen.palette[index]))
        << int{index};
  }
}

IndexedScreen with_codes(ImageSize size, std::mt19937& random) {
  IndexedScreen screen{size, std::vector<std::uint8_t>(size.pixels()), {}, {}};
  const auto code = [&] { return static_cast<std::uint8_t>(random() % 64); };
  for (Rgb8& colour : screen.palette) colour = eltek::dac_colour({code(), code(), code()});
  return screen;
}

TEST(SixelOracle, All64CodesOfEachPrimaryComeBack) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    IndexedScreen screen{{8, 8}, std::vector<std::uint8_t>(64), {}, {}};
    for (std::size_t i = 0; i < 64; ++i) {
      screen.indices[i] = static_cast<std::uint8_t>(i);
      quant::DacCode codes{};
      codes[channel] = static_cast<std::uint8_t>(i);
      screen.palette[i] = eltek::dac_colour(codes);
    }
    expect_round_trip(screen);
  }
}

TEST(SixelOracle, All256EntriesComeBack) {
  std::mt19937 random(1);
  for (int time = 0; time < 20; ++time) {
    IndexedScreen screen = with_codes({16, 16}, random);
    for (std::size_t i = 0; i < 256; ++i) screen.indices[i] = static_cast<std::uint8_t>(i);
    std::shuffle(screen.indices.begin(), screen.indices.end(), random);
    expect_round_trip(screen);
  }
}

TEST(SixelOracle, RandomFramesComeBack) {
  std::mt19937 random(2);
  for (int time = 0; time < 400; ++time) {
    const auto side = [&] { return static_cast<int>(1 + random() % 90); };
    IndexedScreen screen = with_codes({side(), side()}, random);
    // From noise to long runs, from few registers to all.
    const unsigned run = 1u + static_cast<unsigned>(random() % 60), most = 1u << random() % 9;
    std::uint8_t index = 0;
    for (std::uint8_t& pixel : screen.indices) {
      if (random() % run == 0) index = static_cast<std::uint8_t>(random() % most);
      pixel = index;
    }
    expect_round_trip(screen);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(SixelOracle, AWholeScreenComesBack) {
  std::mt19937 random(3);
  IndexedScreen screen = with_codes({1024, 780}, random);
  for (int row = 0; row < 780; ++row)
    for (int column = 0; column < 1024; ++column)
      screen.indices[static_cast<std::size_t>(row * 1024 + column)] =
          static_cast<std::uint8_t>(column * row / 97 + column / 5);
  expect_round_trip(screen);
}

}  // namespace
}  // namespace sir::viewer
