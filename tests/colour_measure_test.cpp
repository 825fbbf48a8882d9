// The measure of the method `best` against CIEDE2000, Lab and the bytes.
#include "quant/colour_measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/ciede2000_oracle.h"

namespace sir::quant {
namespace {

using test::ciede2000_squared;
using test::WideLab;

struct Published {
  WideLab a, b;
  double difference;
};

// Of the pairs in tests/metrics_ciede2000_test.cpp, those at the turns of the formula.
constexpr Published kPublished[] = {
    {{50, 2.6772L, -79.7751L}, {50, 0, -82.7485L}, 2.0425},
    {{50, -1.3802L, -84.2814L}, {50, 0, -82.7485L}, 1.0000},
    {{50, 0, 0}, {50, -1, 2}, 2.3669},
    {{50, 2.49L, -0.001L}, {50, -2.49L, 0.0009L}, 7.1792},
    {{50, 2.49L, -0.001L}, {50, -2.49L, 0.0011L}, 7.2195},
    {{50, -0.001L, 2.49L}, {50, 0.0011L, -2.49L}, 4.7461},
    {{50, 2.5L, 0}, {58, 24, 15}, 19.4535},
    {{60.2574L, -34.0099L, 36.2677L}, {60.4626L, -34.1751L, 39.4387L}, 1.2644},
    {{22.7233L, 20.0904L, -46.6940L}, {23.0331L, 14.9730L, -42.5619L}, 2.0373},
    {{90.9257L, -0.5406L, -0.9208L}, {88.6381L, -0.8985L, -0.7239L}, 1.5381},
    {{2.0776L, 0.0795L, -1.1350L}, {0.9033L, -0.0636L, -0.5514L}, 0.9082},
};

TEST(Ciede2000Oracle, EqualsThePublishedPairs) {
  for (const auto& [a, b, difference] : kPublished)
    EXPECT_NEAR(static_cast<double>(std::sqrt(ciede2000_squared(a, b))), difference, 5.1e-5);
}

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

Lab polar(double l, double chroma, double degrees) {
  const double radians = degrees * std::numbers::pi / 180;
  return {l, chroma * std::cos(radians), chroma * std::sin(radians)};
}

/// The greatest of |CIEDE2000^2 - form| / h^3 over random displacements of length h: what the
/// third order amounts to.
double third_order(std::mt19937& random, const Lab& at, int displacements = 12) {
  const Form form = local_ciede2000(at);
  double worst = 0;
  for (int n = 0; n < displacements; ++n) {
    double d[3];
    for (double& one : d) one = uniform(random, -1, 1);
    const double h = std::pow(10, uniform(random, -3, -2)) / std::hypot(d[0], d[1], d[2]);
    for (double& one : d) one *= h;
    const double x = d[0], y = d[1], z = d[2], length = std::hypot(x, y, z);
    const auto wide = [](double a) { return static_cast<long double>(a); };
    const WideLab from{at.l, at.a, at.b};
    const WideLab to{wide(at.l) + wide(x), wide(at.a) + wide(y), wide(at.b) + wide(z)};
    const double local = double{form.xx} * x * x + double{form.yy} * y * y +
                         double{form.zz} * z * z + double{form.yz} * y * z;
    const double off = static_cast<double>(ciede2000_squared(from, to)) - local;
    worst = std::max(worst, std::abs(off) / std::pow(length, 3));
  }
  return worst;
}

// The factors of CIEDE2000 change by at most some tenths of their value from one colour to the
// next at distance 1, so that much of the square is the third order: a share of h. At h = 1e-3 a
// form that were wrong by a thousandth of its value would show.
constexpr double kThirdOrder = 0.25;

TEST(LocalCiede2000, IsCiede2000UpToTheThirdOrder) {
  std::mt19937 random(1);
  for (int n = 0; n < 8000; ++n) {
    const Lab at{uniform(random, 0, 100), uniform(random, -110, 110), uniform(random, -110, 110)};
    ASSERT_LT(third_order(random, at), kThirdOrder) << at.l << ' ' << at.a << ' ' << at.b;
  }
}

TEST(LocalCiede2000, IsSoWhereItsTermsTurn) {
  std::mt19937 random(2);
  for (int n = 0; n < 1500; ++n) {
    const double l = uniform(random, 0, 100), any = uniform(random, 0, 360);
    for (const Lab& at :
         {polar(l, 0, 0), polar(l, uniform(random, 0, 0.05), any),        // the grey axis
          polar(l, uniform(random, 20, 30), any),                         // where a is stretched
          polar(l, uniform(random, 10, 130), uniform(random, 265, 285)),  // the blue rotation
          polar(uniform(random, 49.9, 50.1), 30, any),                    // middle lightness
          polar(l, 60, uniform(random, -0.5, 0.5))})                      // where hues wrap
      ASSERT_LT(third_order(random, at), kThirdOrder) << at.l << ' ' << at.a << ' ' << at.b;
    for (const double end : {0.0, 100.0})  // black, white
      ASSERT_LT(third_order(random, {end, 0, 0}), kThirdOrder);
  }
}

TEST(ColourMeasure, FormsArePositiveAllOverTheCube) {
  ColourMeasure measure(Goal::perceptual);
  for (int cube = 0; cube < 1 << 18; ++cube) {
    const auto byte = [&](int shift) {
      return static_cast<std::uint8_t>((cube >> shift & 63) * 4);
    };
    const Rgb8 low{byte(12), byte(6), byte(0)};
    const Form form = measure.form_of(low);
    ASSERT_GT(form.xx, 0.0f);
    ASSERT_GT(form.yy, 0.0f);
    ASSERT_GT(form.zz, 0.0f);
    // With room for the rounding of a sum of three floats, so that no difference is below 0.
    ASSERT_LT(double{form.yz} * double{form.yz}, 3.99 * double{form.yy} * double{form.zz})
        << int{low.r} << ' ' << int{low.g} << ' ' << int{low.b};
  }
}

TEST(ColourMeasure, TheFormIsThatOfTheCubesCentre) {
  ColourMeasure measure(Goal::perceptual);
  std::mt19937 random(3);
  for (int n = 0; n < 20000; ++n) {
    const auto number = static_cast<std::uint32_t>(random());
    const Rgb8 colour{static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8),
                      static_cast<std::uint8_t>(number >> 16)};
    const auto centre = [](std::uint8_t byte) { return (byte / 4 * 4 + 1.5) / 255; };
    const Form expected =
        local_ciede2000(lab_of(Rgb{centre(colour.r), centre(colour.g), centre(colour.b)}));
    const Form form = measure.form_of(colour);
    ASSERT_EQ(form.xx, expected.xx);
    ASSERT_EQ(form.yy, expected.yy);
    ASSERT_EQ(form.zz, expected.zz);
    ASSERT_EQ(form.yz, expected.yz);
  }
}

TEST(ColourMeasure, APointIsTheColoursLab) {
  ColourMeasure measure(Goal::perceptual);
  std::mt19937 random(4);
  for (int n = 0; n < 100000; ++n) {
    const auto number = static_cast<std::uint32_t>(random());
    const auto byte = [&](int shift) { return static_cast<std::uint8_t>(number >> shift); };
    const Rgb8 colour = n < 256 ? Rgb8{static_cast<std::uint8_t>(n), static_cast<std::uint8_t>(n),
                                       static_cast<std::uint8_t>(n)}
                                : Rgb8{byte(0), byte(8), byte(16)};
    const Lab lab = lab_of(colour);
    const glm::vec3 point = measure.point_of(colour);
    ASSERT_NEAR(double{point.x}, lab.l, 1e-4) << number;
    ASSERT_NEAR(double{point.y}, lab.a, 1e-4) << number;
    ASSERT_NEAR(double{point.z}, lab.b, 1e-4) << number;
    ASSERT_EQ(measure.point_of(colour), point);  // as remembered
  }
}

// The local form is taken for differences of a few units; there it must not be far off.
TEST(ColourMeasure, DifferencesOfNeighboursAreNearlyCiede2000) {
  ColourMeasure measure(Goal::perceptual);
  std::mt19937 random(5);
  double sum = 0, sum_off = 0;
  for (int n = 0; n < 50000; ++n) {
    const auto near = [&](int byte) {
      return static_cast<std::uint8_t>(
          std::clamp(byte + static_cast<int>(random() % 9) - 4, 0, 255));
    };
    const Rgb8 a{static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
                 static_cast<std::uint8_t>(random())};
    const Rgb8 b{near(a.r), near(a.g), near(a.b)};
    if (a == b) continue;
    const double exact = ciede2000(lab_of(a), lab_of(b)),
                 form = std::sqrt(double{measure.difference(a, b)});
    sum += exact;
    sum_off += std::abs(exact - form);
  }
  EXPECT_LT(sum_off, 0.025 * sum);
}

TEST(ColourMeasure, OfBytesIsTheSquaredDistance) {
  ColourMeasure measure(Goal::psnr);
  std::mt19937 random(6);
  for (int n = 0; n < 100000; ++n) {
    const auto byte = [&] { return static_cast<std::uint8_t>(random()); };
    const Rgb8 a{byte(), byte(), byte()};
    Rgb8 b{byte(), byte(), byte()};
    if (n % 2 == 0) b = {a.r, static_cast<std::uint8_t>(a.g ^ 1), a.b};
    const double square = std::pow(a.r - b.r, 2) + std::pow(a.g - b.g, 2) + std::pow(a.b - b.b, 2);
    ASSERT_NEAR(double{measure.difference(a, b)}, square, 1e-3 * square);
  }
}

TEST(ColourMeasure, AColourIsNoDistanceFromItself) {
  for (const Goal goal : {Goal::perceptual, Goal::psnr}) {
    ColourMeasure measure(goal);
    for (std::uint32_t number = 0; number < 1u << 24; number += 997) {
      const Rgb8 colour{static_cast<std::uint8_t>(number >> 16),
                        static_cast<std::uint8_t>(number >> 8), static_cast<std::uint8_t>(number)};
      ASSERT_EQ(measure.difference(colour, colour), 0.0f);
    }
  }
}

}  // namespace
}  // namespace sir::quant
