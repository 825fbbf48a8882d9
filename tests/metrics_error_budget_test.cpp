// The error budget: parts that make up the whole, and what each may be.
#include "quant/error_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "quant/choose.h"
#include "quant/lattice.h"
#include "quant/metrics.h"
#include "quant/shown_through.h"
#include "tests/random_planes.h"

namespace sir::quant {
namespace {

/// Two soft gradients and a little noise: some thousand colours.
Planes picture() {
  std::mt19937 random(21);
  Planes image(ImageSize{160, 120});
  for (std::size_t i = 0; i < image.size.pixels(); ++i) {
    const auto x = static_cast<unsigned>(i % 160), y = static_cast<unsigned>(i / 160);
    image.set(i, {static_cast<std::uint8_t>(x + y / 2), static_cast<std::uint8_t>(2 * y),
                  static_cast<std::uint8_t>(200 - x + random() % 4)});
  }
  return image;
}

Lut lut_of(const Planes& image, Space space) {
  ChooseOptions options;
  options.space = space;
  return choose_lut(image, options);
}

TEST(ErrorBudget, PartsMakeUpTheErrorThatIsMeasured) {
  const Planes image = picture();
  for (const Space space : {Space::rgb, Space::hsv}) {
    const Lut lut = lut_of(image, space);
    const ImageMetrics metrics = measure(image, shown_through(image, lut));
    const ErrorBudget de = error_budget(image, lut), mse = square_error_budget(image, lut);
    EXPECT_NEAR(de.total, metrics.de_mean, 1e-9);
    EXPECT_NEAR(de.entries + de.dac + de.mapping, de.total, 1e-12);
    EXPECT_GT(de.entries, 0);
    EXPECT_GE(de.mapping, 0);
    EXPECT_NEAR(mse.total, metrics.rmse * metrics.rmse, 1e-9);
    EXPECT_NEAR(mse.entries + mse.dac, mse.total, 1e-12);
    EXPECT_GT(mse.dac, 0);
    EXPECT_EQ(mse.mapping, 0);
  }
}

TEST(ErrorBudget, OfEntriesThatAreTheColoursIsTheDacAlone) {
  // Two colours and a LUT of their codes: what is left is rounding.
  Planes image(ImageSize{2, 1});
  image.set(0, {101, 50, 7});
  image.set(1, {200, 30, 90});
  const Lut lut = make_lut(std::vector<DacCode>{{25, 12, 2}, {49, 7, 22}});
  const std::vector<Rgb> exact{{101 / 255.0, 50 / 255.0, 7 / 255.0},
                               {200 / 255.0, 30 / 255.0, 90 / 255.0}};
  for (const ErrorBudget& budget : {error_budget(image, lut, exact), error_budget(image, lut)}) {
    EXPECT_NEAR(budget.entries, 0, 1e-5);
    EXPECT_GT(budget.dac, 0);
    EXPECT_EQ(budget.mapping, 0);
  }
}

TEST(ErrorBudget, RoundsToTheBitsOfTheLutsDac) {
  // The same two colours. In 5,6,5 bits the codes are seen as 99 49 8 and 197 28 90: off by
  // 2 1 1 and 3 2 0. In 8 bits nothing is rounded.
  Planes image(ImageSize{2, 1});
  image.set(0, {101, 50, 7});
  image.set(1, {200, 30, 90});
  const Lut coarse = make_lut(std::vector<DacCode>{{12, 12, 1}, {24, 7, 11}}, {{5, 6, 5}});
  const ErrorBudget square = square_error_budget(image, coarse);
  EXPECT_NEAR(square.total, (6 / 3.0 + 13 / 3.0) / 2, 1e-12);
  EXPECT_NEAR(square.dac, square.total, 1e-9);
  const ErrorBudget difference = error_budget(image, coarse);
  EXPECT_NEAR(difference.total, measure(image, shown_through(image, coarse)).de_mean, 1e-12);
  EXPECT_NEAR(difference.entries, 0, 1e-5);
  EXPECT_NEAR(difference.dac, difference.total, 1e-5);
  const Lut fine = make_lut(std::vector<DacCode>{{101, 50, 7}, {200, 30, 90}}, {{8, 8, 8}});
  EXPECT_EQ(error_budget(image, fine).total, 0);
  EXPECT_EQ(square_error_budget(image, fine).total, 0);
}

TEST(ErrorBudget, BlamesTheMappingWhereAnotherEntryLooksBetter) {
  // In bytes the blue is nearer to black than to the brighter blue; to the eye it is not.
  Planes image(ImageSize{1, 1});
  image.set(0, seen({0, 0, 20}));
  const Lut lut = make_lut(std::vector<DacCode>{{0, 0, 0}, {0, 0, 41}});
  const Lab blue = lab_of(image.at(0));
  const double to_black = ciede2000(blue, lab_of(seen({0, 0, 0})));
  const double to_blue = ciede2000(blue, lab_of(seen({0, 0, 41})));
  ASSERT_GT(to_black, to_blue);
  const ErrorBudget budget = error_budget(image, lut);
  EXPECT_NEAR(budget.total, to_black, 1e-12);
  EXPECT_NEAR(budget.mapping, to_black - to_blue, 1e-12);
}

TEST(ErrorBudget, OfColoursThatTheLutHoldsIsNothing) {
  Planes image(ImageSize{3, 1});
  const std::vector<DacCode> codes{{0, 0, 0}, {63, 63, 63}, {31, 5, 60}};
  for (std::size_t i = 0; i < 3; ++i) image.set(i, seen(codes[i]));
  const ErrorBudget budget = error_budget(image, make_lut(codes));
  EXPECT_EQ(budget.total, 0);
  EXPECT_EQ(budget.mapping, 0);
}

TEST(ErrorBudget, RefusesWhatHasNoMean) {
  EXPECT_THROW(error_budget(Planes(), Lut{}), std::invalid_argument);
  EXPECT_THROW(error_budget(picture(), Lut{}, {}), std::invalid_argument);
  EXPECT_THROW(square_error_budget(Planes(), Lut{}), std::invalid_argument);
}

TEST(UnroundedColours, BecomeTheEntries) {
  const Planes image = picture();
  const Lut lut = lut_of(image, Space::hsv);
  std::vector<DacCode> codes;
  for (std::size_t i = 0; i < lut.chosen; ++i)
    if (std::find(codes.begin(), codes.end(), lut.entry[i]) == codes.end())
      codes.push_back(lut.entry[i]);
  const auto colours = unrounded_colours(image, lut);
  ASSERT_EQ(colours.size(), codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const double primary = c == 0 ? colours[i].r : c == 1 ? colours[i].g : colours[i].b;
      EXPECT_LE(std::abs(63 * primary - codes[i][c]), 0.5 + 1e-9);
      EXPECT_GE(primary, 0);
      EXPECT_LE(primary, 1);
    }
}

TEST(UnroundedColours, OfAnyDacBecomeItsCodes) {
  const Planes image = picture();
  for (const DacBits& dac : {DacBits{{5, 6, 5}}, DacBits{{3, 3, 2}}, DacBits{{8, 8, 8}}}) {
    std::set<DacCode> codes;
    for (std::size_t i = 0; i < image.size.pixels(); i += 97)
      codes.insert(nearest_code(image.at(i), dac));
    codes.insert(DacCode{1, 0, 1});  // shows no pixel
    const std::vector<DacCode> entries(codes.begin(), codes.end());
    const Lut lut = make_lut(entries, dac);
    const auto colours = unrounded_colours(image, lut);
    ASSERT_EQ(colours.size(), entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) {
        const double primary = c == 0 ? colours[i].r : c == 1 ? colours[i].g : colours[i].b;
        EXPECT_LE(std::abs(dac.max_code(c) * primary - entries[i][c]), 0.5 + 1e-9);
      }
    const ErrorBudget budget = square_error_budget(image, lut);
    EXPECT_NEAR(budget.entries + budget.dac, budget.total, 1e-12);
    EXPECT_GE(budget.dac, -1e-9);
  }
}

/// Blues, about which CIEDE2000 is most oblique.
Planes blues(Planes image) {
  for (std::size_t i = 0; i < image.size.pixels(); ++i) {
    const Rgb8 c = image.at(i);
    image.set(i, {static_cast<std::uint8_t>(c.r / 3), static_cast<std::uint8_t>(c.g / 4),
                  static_cast<std::uint8_t>(100 + c.b / 2)});
  }
  return image;
}

TEST(LeastDifference, IsThatOfAllComparisons) {
  const auto check = [](const Planes& colours, const Planes& asked) {
    std::vector<Lab> labs;
    for (std::size_t i = 0; i < colours.size.pixels(); ++i) {
      labs.push_back(lab_of(colours.at(i)));
      if (i != 0 && i != 1 && i != 40 && i != 255) continue;
      const LeastDifference least(labs);
      for (std::size_t j = 0; j < asked.size.pixels(); ++j) {
        const Lab colour = lab_of(asked.at(j));
        double expected = ciede2000(colour, labs[0]);
        for (const Lab& other : labs) expected = std::min(expected, ciede2000(colour, other));
        ASSERT_EQ(least(colour), expected);
      }
    }
  };
  const Planes some = test::random_planes({128, 2}, 22), asked = test::random_planes({50, 20}, 23);
  check(some, asked);
  check(blues(some), blues(asked));
}

}  // namespace
}  // namespace sir::quant
