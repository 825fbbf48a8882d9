// The method best, mapping by the eye and dither on the price list: its rows are what the other
// commands make.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/cost/cost_plots.h"
#include "cli/cost/gnuplot.h"
#include "cli/cost/lut_settings.h"
#include "quant/blurred_difference.h"
#include "tests/cli_fixture.h"
#include "viewer/png_file.h"

namespace sir::test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

// A picture of more colours than a LUT has: hues across, brightness down.
class CostOfBest : public CliTest {
 protected:
  CostOfBest() : picture(ImageSize{64, 48}) {
    for (std::size_t i = 0; i < picture.size.pixels(); ++i) {
      const auto x = static_cast<std::uint8_t>(i % 64), y = static_cast<std::uint8_t>(i / 64);
      picture.set(i, {static_cast<std::uint8_t>(x * 4), static_cast<std::uint8_t>(y * 5),
                      static_cast<std::uint8_t>(255 - x * 2 - y)});
    }
    viewer::write_rgb_png(folder / "p.png", picture);
  }

  json priced(const std::string& only) const {
    const Ended ended = sir({"cost", "p.png", "--only", only, "--repeats", "1", "--json"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return json::parse(ended.out)["images"][0];
  }

  Planes picture;
};

const json& row_of(const json& image, const std::string& choice) {
  for (const json& row : image["rows"])
    if (row["choice"] == choice) return row;
  throw std::runtime_error("no row " + choice);
}

TEST_F(CostOfBest, RowsAreWhatTheOtherCommandsMake) {
  const json image = priced("effort,map,dither");
  struct Made {
    std::string choice;
    Words lut, show;
  };
  const Words best{"--method", "best"}, eye{"--map", "perceptual"};
  for (const Made& made : std::vector<Made>{
           {"best --effort 1", {"--method", "best", "--effort", "1"}, eye},
           {"best --effort 3", best, eye},
           {"best --goal psnr --effort 2",
            {"--method", "best", "--goal", "psnr", "--effort", "2"},
            {}},
           {"best, --map rgb", best, {"--map", "rgb"}},
           {"median hsv, --map perceptual", {}, eye},
           {"best, --dither floyd", best, {"--map", "perceptual", "--dither", "floyd"}},
           {"best, --dither blue-noise", best, {"--map", "perceptual", "--dither", "blue-noise"}},
           {"median hsv, --dither floyd", {}, {"--dither", "floyd"}},
           {"median hsv, --dither blue-noise", {}, {"--dither", "blue-noise"}}}) {
    Words lut{"lut", "p.png", "-o", "p.LUT", "--json"};
    lut.insert(lut.end(), made.lut.begin(), made.lut.end());
    const Ended chosen = sir(lut);
    ASSERT_EQ(chosen.exit_code, 0) << chosen.err;
    Words show{"show", "p.png", "--crop", "--png", "shown.png"};
    show.insert(show.end(), made.show.begin(), made.show.end());
    const Ended shown = sir(show);
    ASSERT_EQ(shown.exit_code, 0) << shown.err;
    const json metrics = json::parse(sir({"metrics", "p.png", "shown.png", "--json"}).out);
    const json& row = row_of(image, made.choice);
    for (const char* key : {"psnr", "rmse", "de_mean", "de_p95", "hue_loss"})
      EXPECT_EQ(row[key], metrics[key]) << made.choice << " " << key;
    EXPECT_EQ(row["entries"], json::parse(chosen.out)["entries"]) << made.choice;
    EXPECT_EQ(row["de_blurred"],
              quant::blurred_difference(picture, viewer::read_png(folder / "shown.png")))
        << made.choice;
  }
  EXPECT_EQ(row_of(image, "best --effort 1")["colours"], 64 * 48);  // all are different
}

TEST_F(CostOfBest, ARowToCompareWithIsThereForEachKnob) {
  for (const auto& [knob, rows] : {std::pair("effort", 11), {"map", 4}, {"dither", 6}}) {
    const json image = priced(knob);
    EXPECT_EQ(image["rows"].size(), static_cast<std::size_t>(rows)) << knob;
    EXPECT_EQ(image["rows"][0]["choice"], "median hsv --split pixels") << knob;
    EXPECT_EQ(row_of(image, "best --effort 3")["knob"], knob);
  }
  EXPECT_EQ(priced("effort,map,dither")["rows"].size(), 17u);  // that row once
}

// Pixel by pixel dither is noise, from afar it is nearer. (Where single pixels of a steep slope are
// met well already, as by `best` here, that need not be so of a dither by place.)
TEST_F(CostOfBest, DitherIsJudgedAfterABlur) {
  const json image = priced("dither");
  for (const auto& [with, without] :
       {std::pair("best, --dither floyd", "best --effort 3"),
        {"median hsv, --dither floyd", "median hsv --split pixels"},
        {"median hsv, --dither blue-noise", "median hsv --split pixels"}}) {
    const json &dithered = row_of(image, with), &plain = row_of(image, without);
    EXPECT_LT(dithered["de_blurred"], plain["de_blurred"]) << with;
    EXPECT_GT(dithered["de_mean"], plain["de_mean"]) << with;
  }
}

TEST_F(CostOfBest, TextAndPageHaveTheColumnAndItsMeaning) {
  const Ended ended = sir({"cost", "p.png", "--only", "map", "--repeats", "1", "--html", "p.html"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  for (const std::string& text : {ended.out, folder.read("p.html")})
    for (const char* part : {"blurred", "dE mean after a Gaussian blur", "best, --map rgb",
                             "the method best, beyond the thesis"})
      EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(CostOfBestPlot, HasACurveForEachGoal) {
  cli::CostPart part;
  for (const cli::LutSetting& setting : cli::lut_settings({cli::Knob::effort}, std::nullopt)) {
    cli::CostRow& row = part.rows.emplace_back();
    row.knob = setting.knob;
    row.name = row.subject = setting.name;
    row.family = setting.family;
    row.at = setting.at;
    row.ms = {10.0 + setting.at};
    row.picture.psnr = 40 + setting.at;
    row.picture.de_mean = 1 / (1 + setting.at);
  }
  cli::settle(part);
  const auto plots = cli::lut_plots(part);
  ASSERT_EQ(plots.size(), 2u);
  const std::string& script = plots[1].script;
  for (const char* piece :
       {"\"best, perceptual\"", "\"best, psnr\"", "15 0.16666666666666666 45 5"})
    EXPECT_NE(script.find(piece), std::string::npos) << piece << "\n" << script;
  if (std::system("command -v gnuplot >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "gnuplot is not installed (Debian: gnuplot-nox)";
  const cli::Drawing drawing = cli::draw(script);
  EXPECT_EQ(drawing.failure, "") << script;
  EXPECT_NE(drawing.svg.find("best, perceptual"), std::string::npos);
}

}  // namespace
}  // namespace sir::test
