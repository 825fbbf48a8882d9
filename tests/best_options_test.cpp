// Options of the method `best`: pins, reserved indices, a LUT to start from, importance, hues.
#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/made_up.h"
#include "quant/best.h"
#include "quant/hue_guard.h"
#include "quant/lattice.h"
#include "quant/shown_through.h"
#include "tests/best_pictures.h"
#include "tests/claim_ball.h"

namespace sir::test {
namespace {

using namespace quant;
using testing::HasSubstr;

std::string refusal(const BestOptions& options, const WeightedColours& colours) {
  try {
    choose_best(colours, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "taken";
}

TEST(BestOptions, BadOnesAreRefusedInWords) {
  const WeightedColours colours = colours_of(slopes({20, 20}));
  using Change = std::function<void(BestOptions&)>;
  const Change cannot[] = {[](auto& o) { o.entries = 0; },
                           [](auto& o) { o.entries = 257; },
                           [](auto& o) { o.reserved.set(9); },
                           [](auto& o) {
                             o.entries = 1, o.pins = {{{}, {1, 1, 1}}, {{}, {2, 2, 2}}};
                           },
                           [](auto& o) {
                             o.pins = {{{}, {0, 64, 0}}};
                           },
                           [](auto& o) {
                             o.dac = {{4, 4, 4}}, o.pins = {{7, {16, 0, 0}}};
                           },
                           [](auto& o) {
                             o.pins = {{7, {1, 0, 0}}, {7, {1, 0, 0}}};
                           },
                           [](auto& o) {
                             o.entries = 200, o.reserved.set(7), o.pins = {{7, {1, 0, 0}}};
                           },
                           [](auto& o) {
                             o.pins = {{256, {1, 0, 0}}};
                           },
                           [](auto& o) {
                             o.from = make_lut(std::vector<DacCode>{{1, 1, 1}}, {{5, 6, 5}});
                           },
                           [](auto& o) { o.effort = 0; },
                           [](auto& o) { o.effort = 6; },
                           [](auto& o) {
                             o.dac = {{6, 9, 6}};
                           }};
  const char* const named[] = {"0 entries",     "257 entries",    "255 indices", "2 pins",
                               "pin 0,64,0",    "pin 7=16,0,0",   "second",      "reserved index",
                               "pin 256=1,0,0", "of another DAC", "effort",      "effort",
                               "1 to 8 bits"};
  static_assert(std::size(cannot) == std::size(named));
  for (std::size_t i = 0; i < std::size(cannot); ++i) {
    BestOptions options;
    cannot[i](options);
    EXPECT_THAT(refusal(options, colours), HasSubstr(named[i]));
  }
  EXPECT_THAT(refusal({}, WeightedColours()), HasSubstr("no colours"));
  EXPECT_EQ(refusal({}, colours), "taken");
}

TEST(BestPins, StandWhereTheyWerePutAndCount) {
  const Planes picture = slopes({60, 40});
  for (const Goal goal : kGoals) {
    BestOptions options;
    options.goal = goal;
    options.entries = 12;
    options.pins = {{{}, {1, 2, 3}}, {0, {63, 0, 63}}, {200, {9, 9, 9}}, {{}, {1, 2, 3}}};
    const BestChoice choice = best_for(picture, options);
    EXPECT_EQ(choice.entries, 12u);
    EXPECT_EQ(choice.lut.entry[0], (DacCode{63, 0, 63}));
    EXPECT_EQ(choice.lut.entry[1], (DacCode{1, 2, 3}));
    EXPECT_EQ(choice.lut.entry[2], (DacCode{1, 2, 3}));
    EXPECT_EQ(choice.lut.entry[200], (DacCode{9, 9, 9}));
    EXPECT_EQ(choice.lut.chosen, 201u);
    // What is not used repeats what stands before.
    for (std::size_t i = 11; i < 200; ++i) EXPECT_EQ(choice.lut.entry[i], choice.lut.entry[10]);
    for (std::size_t i = 201; i < 256; ++i) EXPECT_EQ(choice.lut.entry[i], (DacCode{9, 9, 9}));
  }
}

// A pin serves what is near to it: no entry is spent on that once more.
TEST(BestPins, ServeTheirColours) {
  const Planes picture = clusters({60, 40}, 1, 9, 2);
  const BestChoice plain = best_for(picture);
  BestOptions options;
  options.pins = {{100, plain.lut.entry[4]}, {101, plain.lut.entry[0]}};
  const BestChoice choice = best_for(picture, options);
  EXPECT_EQ(choice.entries, plain.entries);
  EXPECT_EQ(std::set(choice.lut.entry.begin(), choice.lut.entry.end()),
            std::set(plain.lut.entry.begin(), plain.lut.entry.end()));
}

TEST(BestPins, AloneMakeALut) {
  BestOptions options;
  options.entries = 2;
  options.pins = {{5, {10, 10, 10}}, {3, {60, 0, 0}}};
  const Planes picture = slopes({30, 30});
  const BestChoice choice = best_for(picture, options);
  EXPECT_EQ(choice.entries, 2u);
  // Before the first of them nothing can be repeated: it is the first pin, seen alike.
  for (std::size_t i = 0; i < 256; ++i)
    EXPECT_EQ(choice.lut.entry[i], i < 3 || i > 4 ? (DacCode{10, 10, 10}) : (DacCode{60, 0, 0}));
  EXPECT_NEAR(choice.error, error_of(Goal::perceptual, picture, choice.lut), 1e-3);
}

TEST(BestFrom, CountsARepeatedEntryOnce) {
  const Planes picture = filled({3, 3}, {40, 90, 200});
  BestOptions options;
  options.from = make_lut(std::vector<DacCode>{{1, 2, 3}, {10, 22, 49}, {60, 60, 60}});
  const BestChoice choice = best_for(picture, options);
  EXPECT_EQ(choice.entries, std::set(choice.lut.entry.begin(), choice.lut.entry.end()).size());
  EXPECT_LT(choice.entries, 5u);
}

TEST(BestReserved, AreLeftToOthers) {
  const Planes picture = slopes({60, 40});
  BestOptions options;
  for (std::size_t i = 0; i < 16; ++i) options.reserved.set(i);
  options.reserved.set(255);
  options.entries = 239;
  options.pins = {{{}, {63, 63, 63}}};
  for (const bool from : {false, true}) {
    std::vector<DacCode> codes(256, {3, 40, 7});
    codes[255] = {1, 2, 3};
    if (from) options.from = make_lut(codes);
    const BestChoice choice = best_for(picture, options);
    EXPECT_EQ(choice.entries, 239u);
    for (std::size_t i = 0; i < 16; ++i)
      EXPECT_EQ(choice.lut.entry[i], from ? (DacCode{3, 40, 7}) : DacCode{});
    EXPECT_EQ(choice.lut.entry[255], from ? (DacCode{1, 2, 3}) : DacCode{});
    EXPECT_EQ(choice.lut.entry[16], (DacCode{63, 63, 63}));
    // As good as with so many entries anywhere.
    BestOptions anywhere;
    anywhere.entries = 239;
    anywhere.pins = options.pins;
    const double error = best_for(picture, anywhere).error;
    if (from) EXPECT_LT(choice.error, 1.02 * error);
    else EXPECT_DOUBLE_EQ(choice.error, error);
  }
}

TEST(BestFrom, AnUnchangedPictureLosesNothing) {
  for (const Planes& picture :
       {slopes({90, 60}), thinned(bench::grainy_balls(), 5), clusters({80, 60}, 1, 40, 20)})
    for (const Goal goal : kGoals) {
      BestOptions options;
      options.goal = goal;
      const BestChoice before = best_for(picture, options);
      options.from = before.lut;
      const BestChoice after = best_for(picture, options);
      EXPECT_LE(after.error, before.error * (1 + 1e-6)) << name_of(goal);
      std::size_t near = 0;
      for (std::size_t i = 0; i < 256; ++i) {
        int reach = 0;
        for (std::size_t c = 0; c < 3; ++c)
          reach = std::max(reach, std::abs(after.lut.entry[i][c] - before.lut.entry[i][c]));
        near += reach <= 4;
      }
      EXPECT_GE(near, 230u) << name_of(goal);
    }
}

// However few colours there are to start from, all entries are put to use.
TEST(BestFrom, WhatALutRepeatsIsSpentAtAnyEffort) {
  const Planes picture = slopes({60, 40});
  for (const Goal goal : kGoals)
    for (const int effort : {1, 3}) {
      BestOptions options;
      options.goal = goal;
      options.effort = effort;
      const double error = best_for(picture, options).error;
      for (const std::size_t colours : {1, 3, 16, 128}) {
        std::vector<DacCode> codes;
        for (std::size_t i = 0; i < colours; ++i)
          codes.push_back({static_cast<std::uint8_t>(i * 63 / colours),
                           static_cast<std::uint8_t>(i * 17 % 64),
                           static_cast<std::uint8_t>(i * 29 % 64)});
        options.from = make_lut(codes);
        EXPECT_LT(best_for(picture, options).error, 1.1 * error)
            << name_of(goal) << ", effort " << effort << ", " << colours << " colours";
      }
    }
}

TEST(BestFrom, EntriesThatServeNothingStay) {
  const Planes picture = filled({20, 20}, {250, 10, 10});
  std::vector<DacCode> codes;
  for (int i = 0; i < 64; ++i) {
    const auto level = static_cast<std::uint8_t>(63 - i);
    codes.push_back({level, level, level});
  }
  codes.push_back({63, 2, 2});
  BestOptions options;
  options.from = make_lut(codes);
  const BestChoice choice = best_for(picture, options);
  for (std::size_t i = 0; i < 64; ++i) EXPECT_EQ(choice.lut.entry[i], codes[i]) << i;
  const auto index = map_perceptually(picture, choice.lut).front();
  ColourMeasure measure(Goal::perceptual);
  EXPECT_LE(measure.difference({250, 10, 10}, choice.lut.seen(index)),
            measure.difference({250, 10, 10}, seen(nearest_code({250, 10, 10}, {}))));
}

TEST(BestImportance, IsWhereEntriesGo) {
  const Planes left = random_planes({50, 80}, 1), right = slopes({50, 80});
  Planes both(ImageSize{100, 80});
  std::vector<std::uint8_t> mask(both.size.pixels()), half(mask.size(), 255);
  for (std::size_t i = 0; i < both.size.pixels(); ++i) {
    const std::size_t column = i % 100, from = i / 100 * 50 + column % 50;
    both.set(i, column < 50 ? left.at(from) : right.at(from));
    mask[i] = column < 50 ? 0 : 200;
    if (column < 50) half[i] = 20;
  }
  for (const Goal goal : kGoals) {
    BestOptions options;
    options.goal = goal;
    const auto masked = [&](const std::vector<std::uint8_t>& importance) {
      WeightedColours colours;
      colours.add(both, importance);
      return choose_best(colours, options).lut;
    };
    const double evenly = error_of(goal, right, best_for(both, options).lut);
    const double preferred = error_of(goal, right, masked(half));
    EXPECT_LT(preferred, evenly);
    EXPECT_LT(error_of(goal, right, masked(mask)), preferred);
    // What is masked out has no influence: the LUT is that of the rest.
    Planes other = both;
    for (std::size_t i = 0; i < mask.size(); ++i)
      if (mask[i] == 0) other.set(i, {12, 200, 3});
    WeightedColours without;
    without.add(other, mask);
    EXPECT_EQ(choose_best(without, options).lut, masked(mask));
    for (auto& one : mask) one = one ? 255 : 0;
    EXPECT_EQ(masked(mask), best_for(right, options).lut);
  }
}

/// Planes of the hues, grey included, with at least a pixel.
std::set<int> hues_of(const Planes& picture) {
  std::set<int> planes;
  for (std::size_t i = 0; i < picture.size.pixels(); ++i) planes.insert(hue_plane(picture.at(i)));
  return planes;
}

std::set<int> hues_of(const Lut& lut) {
  std::set<int> planes;
  for (std::size_t i = 0; i < kLutEntries; ++i) planes.insert(hue_plane(lut.seen(i)));
  return planes;
}

TEST(BestHues, AreAllThereWhereTheyFit) {
  std::vector<Planes> pictures{random_planes({70, 50}, 1),
                               thinned(bench::balls(), 5),
                               slopes({60, 60}),
                               clusters({50, 50}, 3, 4, 12),
                               filled({9, 9}, {80, 80, 80}),
                               BallImage(SIR_CLAIM "/ball", {}, {160, 120}).image()};
  for (std::size_t n = 0; n < pictures.size(); ++n)
    for (const Goal goal : kGoals)
      for (const std::size_t entries : {40, 256}) {
        BestOptions options;
        options.goal = goal;
        options.entries = entries;
        options.protect_hues = true;
        const BestChoice choice = best_for(pictures[n], options);
        EXPECT_THAT(choice.lost_hues, testing::IsEmpty()) << n;
        const auto there = hues_of(pictures[n]), kept = hues_of(choice.lut);
        EXPECT_TRUE(std::includes(kept.begin(), kept.end(), there.begin(), there.end())) << n;
      }
}

TEST(BestHues, AsManyAreGuardedAsFit) {
  const Planes picture = random_planes({70, 50}, 1);
  const auto there = hues_of(picture);
  ASSERT_EQ(there.size(), 37u);
  for (const std::size_t entries : {1, 8, 20}) {
    BestOptions options;
    options.entries = entries;
    options.protect_hues = true;
    const BestChoice choice = best_for(picture, options);
    EXPECT_EQ(hues_of(choice.lut).size(), entries);
    EXPECT_EQ(choice.lost_hues.size(), there.size() - entries);
  }
}

TEST(BestHues, CostLittleWhereThereAreEntries) {
  for (const Planes& picture : {random_planes({90, 60}, 1), thinned(bench::grainy_balls(), 4)}) {
    BestOptions options;
    const double free = best_for(picture, options).error;
    options.protect_hues = true;
    EXPECT_LT(best_for(picture, options).error, 1.02 * free);
  }
}

// The small area that the thesis chooses in HSV for (4.4).
TEST(BestBall, IsKeptWithoutBeingProtected) {
  const BallImage scene(SIR_CLAIM "/ball", {}, {320, 240});
  const auto median = [&](Space space) {
    ChooseOptions options;
    options.space = space;
    return scene.ball_difference(shown_through(scene.image(), choose_lut(scene.image(), options)));
  };
  const Lut lut = best_for(scene.image()).lut;
  const double best =
      scene.ball_difference(as_seen(scene.image().size, map_perceptually(scene.image(), lut), lut));
  EXPECT_LT(best, 2.5);  // CIEDE2000
  EXPECT_LT(best, 0.25 * median(Space::rgb));
  EXPECT_LT(best, 1.5 * median(Space::hsv));
}

}  // namespace
}  // namespace sir::test
