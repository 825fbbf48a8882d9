#include "eltek/tube.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <thread>

#include "tests/tube_oracle.h"

namespace sir::eltek {
namespace {

constexpr std::array kSets{PhosphorSet::smpte_c, PhosphorSet::p22_h273, PhosphorSet::p22_dosbox};
constexpr std::array kWhites{WhitePoint::d65, WhitePoint::k9300};
constexpr std::array kGammas{1.0, 1.8, 2.2, 2.5, 4.0};

// The numbers once more, so that a slip in either place shows.
std::array<test::Xy, 3> primaries(PhosphorSet set) {
  switch (set) {
    case PhosphorSet::smpte_c: return {{{.630L, .340L}, {.310L, .595L}, {.155L, .070L}}};
    case PhosphorSet::p22_h273: return {{{.630L, .340L}, {.295L, .605L}, {.155L, .077L}}};
    case PhosphorSet::p22_dosbox: return {{{.647L, .343L}, {.310L, .594L}, {.148L, .062L}}};
  }
  throw std::invalid_argument("no such set");
}

test::Xy white_of(WhitePoint point) {
  return point == WhitePoint::d65 ? test::Xy{.3127L, .3290L} : test::Xy{.2831L, .2971L};
}

Voltages grey(int code) { return {code / 63.0, code / 63.0, code / 63.0}; }

std::array<int, 3> bytes(const quant::Light& light) {
  return {test::srgb_byte(light[0]), test::srgb_byte(light[1]), test::srgb_byte(light[2])};
}

template <class Body>
void for_each_tube(const Body& body) {
  for (const PhosphorSet set : kSets)
    for (const WhitePoint point : kWhites)
      for (const double gamma : kGammas) body(TubeOptions{set, point, gamma});
}

TEST(Tube, AgreesWithMatricesInLongDouble) {
  std::mt19937 random(1);
  std::vector<Voltages> voltages;
  for (int code = 0; code < 64; ++code) voltages.push_back(grey(code));
  for (int i = 0; i < 3000; ++i) {
    const auto code = [&] { return static_cast<double>(random() % 64) / 63; };
    voltages.push_back({code(), code(), code()});
  }
  for_each_tube([&](const TubeOptions& options) {
    const std::vector<quant::Light> light = Tube(options).light_of(voltages);
    for (std::size_t i = 0; i < voltages.size(); ++i) {
      const Voltages& v = voltages[i];
      const test::Three exact = test::tube_light(
          primaries(options.phosphors), white_of(options.white), options.gamma, {v[0], v[1], v[2]});
      for (std::size_t c = 0; c < 3; ++c) {
        // lcms2 works in single precision.
        ASSERT_NEAR(light[i][c], static_cast<double>(exact[c]), 2e-6) << i;
        ASSERT_NEAR(test::srgb_byte(light[i][c]), test::srgb_byte(exact[c]), 1) << i;
      }
    }
  });
}

TEST(Tube, BlackIsBlackAndGreysOfD65AreNeutral) {
  for_each_tube([](const TubeOptions& options) {
    const Tube tube(options);
    for (int code = 0; code < 64; ++code) {
      const Voltages voltages = grey(code);
      const quant::Light light = tube.light_of({&voltages, 1}).front();
      const std::array<int, 3> byte = bytes(light);
      if (code == 0) {
        EXPECT_EQ(light, (quant::Light{0, 0, 0}));
      }
      if (code == 63 && options.white == WhitePoint::d65) {
        EXPECT_EQ(byte, (std::array{255, 255, 255}));
      }
      if (options.white == WhitePoint::d65) {
        EXPECT_EQ(byte[0], byte[1]) << code;
        EXPECT_EQ(byte[1], byte[2]) << code;
      }
    }
  });
}

TEST(Tube, EachGunGrowsBrighterWithItsVoltage) {
  for_each_tube([](const TubeOptions& options) {
    const Tube tube(options);
    for (std::size_t gun = 0; gun < 3; ++gun) {
      std::vector<Voltages> voltages(256);
      for (std::size_t i = 0; i < 256; ++i) voltages[i][gun] = static_cast<double>(i) / 255;
      const std::vector<quant::Light> light = tube.light_of(voltages);
      for (std::size_t i = 1; i < 256; ++i) EXPECT_GT(light[i][gun], light[i - 1][gun]);
    }
  });
}

TEST(Tube, A9300KWhiteStaysBluishAndClipsNothing) {
  for (const PhosphorSet set : kSets) {
    const Tube tube({set, WhitePoint::k9300, 2.2});
    const Voltages most{1, 1, 1};
    const quant::Light light = tube.light_of({&most, 1}).front();
    EXPECT_NEAR(light[2], 1, 1e-6);
    EXPECT_LT(light[0], light[1]);
    EXPECT_LT(light[1], 0.9);
    EXPECT_LT(tube.gain(), 1);
    const test::Three xyz = test::times(test::srgb_to_xyz(), {light[0], light[1], light[2]});
    const long double sum = xyz[0] + xyz[1] + xyz[2];
    EXPECT_NEAR(static_cast<double>(xyz[0] / sum), 0.2831, 1e-6);
    EXPECT_NEAR(static_cast<double>(xyz[1] / sum), 0.2971, 1e-6);
    EXPECT_EQ(Tube({set, WhitePoint::d65, 2.2}).gain(), 1);
  }
}

// CIE 15: the daylight locus above 7000 K.
TEST(Tube, TheWhiteOf9300KIsOnTheDaylightLocus) {
  constexpr double t = 9300;
  const double x = -2.0064e9 / (t * t * t) + 1.9018e6 / (t * t) + 0.24748e3 / t + 0.237040;
  EXPECT_NEAR(white(WhitePoint::k9300).at.x, x, 5e-5);
  EXPECT_NEAR(white(WhitePoint::k9300).at.y, -3 * x * x + 2.87 * x - 0.275, 5e-5);
}

TEST(Tube, SetsOfPhosphorsHaveNamesOfTheirOwn) {
  EXPECT_EQ(phosphors(PhosphorSet::smpte_c).name, "smpte-c");
  EXPECT_EQ(phosphors(PhosphorSet::p22_h273).name, "p22-h273");
  EXPECT_EQ(phosphors(PhosphorSet::p22_dosbox).name, "p22-dosbox");
}

TEST(Tube, RefusesAGammaThatNoTubeHas) {
  for (const double gamma : {0.99, 4.01, -2.2, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()})
    EXPECT_THROW(Tube({PhosphorSet::smpte_c, WhitePoint::d65, gamma}), std::invalid_argument);
}

TEST(Tube, SeveralThreadsMayAskAtOnce) {
  const Tube tube;
  std::vector<Voltages> voltages(5000);
  for (std::size_t i = 0; i < voltages.size(); ++i)
    voltages[i] = {static_cast<double>(i % 64) / 63, static_cast<double>(i % 7) / 6,
                   static_cast<double>(i % 11) / 10};
  const std::vector<quant::Light> alone = tube.light_of(voltages);
  std::array<std::vector<quant::Light>, 4> light;
  {
    std::vector<std::jthread> threads;
    for (auto& own : light)
      threads.emplace_back([&tube, &voltages, &own] {
        for (int i = 0; i < 20; ++i) own = tube.light_of(voltages);
      });
  }
  for (const auto& own : light) EXPECT_EQ(own, alone);
}

}  // namespace
}  // namespace sir::eltek
