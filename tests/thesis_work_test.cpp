// The walk through boxes of 1989: the same LUT as the fast choice, and steps counted by hand.
#include "quant/thesis_work.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <string>

#include "tests/random_planes.h"
#include "tracer/error.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"

namespace sir::quant {
namespace {

constexpr SplitOrder kOrders[] = {SplitOrder::pixels, SplitOrder::breadth, SplitOrder::longest};

ChooseOptions median_cut_in(Space space, SplitOrder split = SplitOrder::pixels) {
  ChooseOptions options;
  options.space = space;
  options.split = split;
  return options;
}

/// Every cell of the RGB grid by one pixel.
Planes all_rgb_cells() {
  Planes image(ImageSize{256, 128});
  for (std::size_t i = 0; i < image.size.pixels(); ++i)
    image.set(i,
              {static_cast<std::uint8_t>(i / 1024 * 8), static_cast<std::uint8_t>(i / 32 % 32 * 8),
               static_cast<std::uint8_t>(i % 32 * 8)});
  return image;
}

/// A few hues at most, many tones: small boxes, and planes with no entry of their own.
Planes few_hues(unsigned seed) {
  std::mt19937 random(seed);
  Planes image(ImageSize{50, 40});
  for (std::size_t i = 0; i < image.size.pixels(); ++i) {
    const auto light = static_cast<unsigned>(random() % 256);
    const auto byte = [&](unsigned share) { return static_cast<std::uint8_t>(light * share / 8); };
    image.set(i, {byte(8), byte(random() % 8), byte(i % 97 == 0 ? random() % 8 : 1)});
  }
  return image;
}

void expect_same_luts(const Planes& image, const std::string& name) {
  for (const SplitOrder split : kOrders)
    for (const Space space : {Space::rgb, Space::hsv}) {
      const ChooseOptions options = median_cut_in(space, split);
      EXPECT_EQ(choose_as_in_1989(image, options).lut, choose_lut(image, options))
          << name << (space == Space::rgb ? " RGB" : " HSV") << ", order "
          << static_cast<int>(split);
    }
}

TEST(ThesisWork, ChoosesTheFastLutOnTheFiveScenes) {
  for (const std::string name : {"whitted", "calice", "luminar", "piramide", "lcg"}) {
    RenderOptions small;
    small.size = {96, 72};
    expect_same_luts(render(read_scene(std::filesystem::path(SIR_IMAGES) / name), small).planes,
                     name);
  }
}

TEST(ThesisWork, ChoosesTheFastLutOnRandomImages) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    expect_same_luts(test::random_planes({40, 30}, seed), "noise " + std::to_string(seed));
    expect_same_luts(few_hues(seed), "few hues " + std::to_string(seed));
  }
}

TEST(ThesisWork, ChoosesTheFastLutOnOtherGridsAndSamples) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    ChooseOptions options = median_cut_in(Space::hsv, kOrders[seed % 3]);
    options.grid.hues = 7;
    options.grid.saturations = 40;
    options.grid.values = 19;
    options.sample = 1 + seed;
    const Planes image = test::random_planes({60, 50}, seed);
    EXPECT_EQ(choose_as_in_1989(image, options).lut, choose_lut(image, options)) << seed;
  }
}

// 32768 cells of a pixel each: all boxes of a round are alike, and every cut is in the middle.
// Cells: the matrix, eight rounds of the whole of it for the distributions, and the means; when
// boxes are shrunk, eight more rounds. Places: boxes of length 32 32 32 16 16 16 8 8 (2^k in
// round k), walked one and a half times: 1.5 * 2656.
TEST(ThesisWork, CountsTheStepsOfAFullMatrix) {
  const Planes image = all_rgb_cells();
  constexpr std::uint64_t kMatrix = 32768, kPlaces = 3984;
  for (const SplitOrder split : {SplitOrder::pixels, SplitOrder::breadth}) {
    const ChooseOptions options = median_cut_in(Space::rgb, split);
    const WorkedLut kept = choose_as_in_1989(image, options, false);
    const WorkedLut shrunk = choose_as_in_1989(image, options, true);
    EXPECT_EQ(kept.work, (ThesisWork{kMatrix, 0, 10 * kMatrix + kPlaces}));
    EXPECT_EQ(shrunk.work, (ThesisWork{kMatrix, 0, 18 * kMatrix + kPlaces}));
    EXPECT_EQ(kept.lut, shrunk.lut);  // nothing is there to shrink away
  }
}

TEST(ThesisWork, CountsConversionsAndTheMatrixInHsv) {
  const Planes image = test::random_planes({40, 30}, 3);
  ChooseOptions options = median_cut_in(Space::hsv);
  WorkedLut chosen = choose_as_in_1989(image, options);
  EXPECT_EQ(chosen.work.pixels_read, 1200u);
  EXPECT_EQ(chosen.work.conversions, 1200u);
  EXPECT_GT(chosen.work.cells_visited, 32430u);
  options.sample = 7;  // the pixels 0, 7... 1197: few colours, so only the matrix is walked
  chosen = choose_as_in_1989(image, options);
  EXPECT_EQ(chosen.work, (ThesisWork{172, 172, 36 * 30 * 30 + 30}));
}

TEST(ThesisWork, ShrinkingPaysWhereColoursFillACorner) {
  Planes corner(ImageSize{64, 64});
  for (std::size_t i = 0; i < corner.size.pixels(); ++i)
    corner.set(i, {static_cast<std::uint8_t>(i % 8 * 8), static_cast<std::uint8_t>(i / 8 % 8 * 8),
                   static_cast<std::uint8_t>(i / 64 % 8 * 8)});  // 8 x 8 x 8 cells, 8 pixels each
  const ChooseOptions options = median_cut_in(Space::rgb);
  const std::uint64_t shrunk = choose_as_in_1989(corner, options).work.cells_visited;
  // By hand: 512 cells cut in half until there are 256 pairs: the matrix, 8 rounds twice, the
  // means; boxes of length 8 8 8 4 4 4 2 2, walked one and a half times.
  EXPECT_EQ(shrunk, 32768u + 17 * 512 + 996);
  EXPECT_GT(choose_as_in_1989(corner, options, false).work.cells_visited, 4 * shrunk);
}

TEST(ThesisWork, WithoutShrinkingEveryColourStillHasItsBox) {
  for (unsigned seed = 0; seed < 4; ++seed)
    for (const SplitOrder split : kOrders)
      for (const Space space : {Space::rgb, Space::hsv})
        EXPECT_EQ(choose_as_in_1989(few_hues(seed), median_cut_in(space, split), false).lut.chosen,
                  choose_lut(few_hues(seed), median_cut_in(space, split)).chosen);
}

TEST(ThesisWork, RefusesWhatItCannotCount) {
  EXPECT_THROW(choose_as_in_1989(Planes{}, median_cut_in(Space::rgb)), FileError);
  ChooseOptions options = median_cut_in(Space::rgb);
  options.sample = 0;
  EXPECT_THROW(choose_as_in_1989(all_rgb_cells(), options), std::invalid_argument);
  options.sample = 1;
  options.method = Method::frequency;
  EXPECT_THROW(choose_as_in_1989(all_rgb_cells(), options), std::invalid_argument);
}

}  // namespace
}  // namespace sir::quant
