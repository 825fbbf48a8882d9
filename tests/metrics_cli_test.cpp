// sir metrics from outside: what it prints and how it ends.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "quant/heat_map.h"
#include "quant/metrics.h"
#include "quant/shown_through.h"
#include "tests/cli_fixture.h"
#include "viewer/png_file.h"

namespace sir::test {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;
using Names = std::vector<std::string>;

const Names kKeys{"psnr", "rmse",    "de_mean", "de_p95",  "de_max",
                  "ssim", "colours", "banding", "hue_loss"};

class MetricsCommandTest : public CliTest {
 protected:
  MetricsCommandTest() {
    render();
    EXPECT_EQ(sir({"lut", "s", "--size", "64x48"}).exit_code, 0);
    EXPECT_EQ(sir({"show", "s", "--size", "64x48", "--crop", "--png", "shown.png"}).exit_code, 0);
    reference = read_planes(folder / "s", {64, 48});
    shown = viewer::read_png(folder / "shown.png");
  }

  Ended metrics(Names more) const {
    more.insert(more.begin(), {"metrics", "s.png", "shown.png"});
    return sir(more);
  }

  Planes reference, shown;
};

Names keys_of(const ordered_json& json) {
  Names keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

TEST_F(MetricsCommandTest, JsonHoldsTheMetricsInOrder) {
  const Ended ended = metrics({"--json"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  const auto json = ordered_json::parse(ended.out);
  Names keys = kKeys;
  keys.push_back("hue_alarms");
  EXPECT_EQ(keys_of(json), keys);
  const auto expected = quant::measure(reference, shown);
  EXPECT_EQ(json["psnr"], expected.psnr.value());
  EXPECT_EQ(json["rmse"], expected.rmse);
  EXPECT_EQ(json["de_mean"], expected.de_mean);
  EXPECT_EQ(json["de_p95"], expected.de_p95);
  EXPECT_EQ(json["de_max"], expected.de_max);
  EXPECT_EQ(json["ssim"], expected.ssim);
  EXPECT_EQ(json["colours"], expected.colours);
  EXPECT_TRUE(json["colours"].is_number_integer());
  EXPECT_EQ(json["banding"], expected.banding);
  EXPECT_EQ(json["hue_loss"], expected.hue_loss);
  EXPECT_TRUE(json["hue_alarms"].is_array());
}

TEST_F(MetricsCommandTest, PlanesAndPngAreTheSameImage) {
  for (const Names& more : {Names{"s", "s.png"}, Names{"s.R", "s"}, Names{"s.png", "s.png"}}) {
    Names arguments{"metrics", "--json", "--size", "64x48"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = sir(arguments);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const auto json = ordered_json::parse(ended.out);
    EXPECT_TRUE(json["psnr"].is_null());
    EXPECT_EQ(json["rmse"], 0.0);
  }
}

TEST_F(MetricsCommandTest, ThresholdsThatAreNotMetAreNamed) {
  const double de = quant::measure(reference, shown).de_mean;
  ASSERT_GT(de, 0);
  const Ended met = metrics({"--fail-above", "de_mean=" + std::to_string(de + 0.001),
                             "--fail-below", "psnr=1", "--fail-below", "colours=0"});
  EXPECT_EQ(met.exit_code, 0) << met.err;
  EXPECT_EQ(met.err, "");
  for (const Names& more : {Names{}, Names{"--json"}}) {
    Names arguments{"--fail-above", "de_mean=-1", "--fail-above", "de_max=1e9",
                    "--fail-below", "psnr=500",   "--fail-below", "ssim=-3"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = metrics(arguments);
    EXPECT_EQ(ended.exit_code, 3);
    EXPECT_EQ(ended.out, metrics(more).out);
    EXPECT_THAT(ended.err, HasSubstr("de_mean is "));
    EXPECT_THAT(ended.err, HasSubstr("above the limit -1\n"));
    EXPECT_THAT(ended.err, HasSubstr("psnr is "));
    EXPECT_THAT(ended.err, HasSubstr("below the limit 500\n"));
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 2) << ended.err;
  }
}

TEST_F(MetricsCommandTest, EveryMetricCanBeALimit) {
  for (const std::string& key : kKeys) {
    EXPECT_EQ(metrics({"--fail-above", key + "=-1"}).exit_code, 3) << key;
    EXPECT_EQ(metrics({"--fail-below", key + "=1e6"}).exit_code, 3) << key;
    EXPECT_EQ(metrics({"--fail-above", key + "=1e6"}).exit_code, 0) << key;
  }
}

TEST_F(MetricsCommandTest, TheLimitItselfPasses) {
  for (const std::string option : {"--fail-above", "--fail-below"})
    EXPECT_EQ(sir({"metrics", "s.png", "s.png", option, "de_max=0", option, "ssim=1"}).exit_code, 0)
        << option;
}

TEST_F(MetricsCommandTest, ThePsnrOfEqualImagesIsAboveAnyLimit) {
  EXPECT_EQ(sir({"metrics", "s.png", "s.png", "--fail-below", "psnr=1e300"}).exit_code, 0);
  EXPECT_EQ(sir({"metrics", "s.png", "s.png", "--fail-above", "psnr=1e300"}).exit_code, 3);
}

TEST_F(MetricsCommandTest, WrongThresholdsAreWrongUsage) {
  for (const std::string wrong : {"", "psnr", "psnr=", "=3", "PSNR=3", "psnr=3dB", "psnr=nan",
                                  "psnr=inf", "psnr=1,5", "hue_alarms=1", "psnr =3", "psnr==3"})
    for (const std::string option : {"--fail-above", "--fail-below"}) {
      const Ended ended = metrics({option, wrong});
      EXPECT_EQ(ended.exit_code, 2) << option << ' ' << wrong;
      EXPECT_EQ(ended.out, "");
      EXPECT_THAT(ended.err, HasSubstr(option));
    }
  EXPECT_EQ(sir({"metrics", "s.png"}).exit_code, 2);
}

TEST_F(MetricsCommandTest, ImagesOfDifferentSizesAreRefused) {
  ASSERT_EQ(sir({"show", "s", "--size", "64x48", "--png", "screen.png"}).exit_code, 0);
  const Ended ended = sir({"metrics", "s.png", "screen.png", "--json"});
  expect_failure(ended, "screen.png: has 1024x780 pixels, but s.png has 64x48");
  EXPECT_THAT(ended.err, HasSubstr("sir show --crop"));
  EXPECT_EQ(ended.out, "");
  expect_failure(sir({"metrics", "s.png", "absent.png"}), "absent.png");
}

TEST_F(MetricsCommandTest, TheHeatMapIsWrittenAndNoInputIsOverwritten) {
  const Ended ended = metrics({"--heat-map", "heat.png", "--fail-below", "psnr=500"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_EQ(viewer::read_png(folder / "heat.png"), quant::heat_map(reference, shown));
  for (const std::string input : {"s.png", "shown.png", "s.LUT"}) {
    const std::string before = folder.read(input);
    EXPECT_EQ(metrics({"--heat-map", input, "--lut", "s.LUT"}).exit_code, 1) << input;
    EXPECT_EQ(folder.read(input), before) << input;
  }
}

TEST_F(MetricsCommandTest, TheBudgetIsThatOfTheLut) {
  const Ended ended = metrics({"--json", "--lut", "s.LUT"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const auto json = ordered_json::parse(ended.out);
  const auto& budget = json["budget"];
  EXPECT_EQ(keys_of(budget), (Names{"total", "entries", "dac", "mapping", "mse"}));
  EXPECT_EQ(keys_of(budget["mse"]), (Names{"total", "entries", "dac", "mapping"}));
  EXPECT_NEAR(budget["total"], json["de_mean"], 1e-9);
  EXPECT_NEAR(budget["mse"]["total"], json["rmse"].get<double>() * json["rmse"].get<double>(),
              1e-9);
  EXPECT_THAT(metrics({"--lut", "s.LUT"}).out, HasSubstr("through the LUT"));
  expect_failure(metrics({"--lut", "absent.LUT"}), "absent.LUT");
}

TEST_F(MetricsCommandTest, HuesThatAreGoneAreNamed) {
  Planes green(ImageSize{20, 10}), grey(ImageSize{20, 10});
  for (std::size_t i = 0; i < 200; ++i) {
    green.set(i, i < 60 ? Rgb8{20, 200, 20} : Rgb8{90, 90, 90});
    grey.set(i, {90, 90, 90});
  }
  viewer::write_rgb_png(folder / "green.png", green);
  viewer::write_rgb_png(folder / "grey.png", grey);
  EXPECT_THAT(sir({"metrics", "green.png", "grey.png"}).out,
              HasSubstr("alarm: hue 120 (green) is gone: 60 of 60 pixels"));
  const auto json = ordered_json::parse(sir({"metrics", "green.png", "grey.png", "--json"}).out);
  EXPECT_EQ(json["hue_alarms"], ordered_json::array({120}));
  EXPECT_EQ(json["hue_loss"], 1.0);
}

TEST_F(MetricsCommandTest, AFullDiskIsReported) {
  Start start;
  start.out_file = "/dev/full";
  EXPECT_EQ(sir({"metrics", "s.png", "shown.png"}, start).exit_code, 1);
}

}  // namespace
}  // namespace sir::test
