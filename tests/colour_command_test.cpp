// sir paint and sir cost from outside.
#include <gtest/gtest.h>
#include <signal.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "quant/choose.h"
#include "quant/nearest.h"
#include "tests/cli_fixture.h"
#include "tracer/planes.h"
#include "viewer/png_file.h"

namespace sir::test {
namespace {

using nlohmann::json;
using Names = std::vector<std::string>;

class ColourCommand : public CliTest {
 protected:
  // Half red of s = 0.2, a quarter blue, a quarter grey; planes and PNG.
  ColourCommand() {
    for (std::size_t i = 0; i < 48; ++i)
      image.set(i, i < 24 ? Rgb8{255, 204, 204} : i < 36 ? Rgb8{0, 0, 200} : Rgb8{100, 100, 100});
    write_planes(folder / "p", image);
    viewer::write_rgb_png(folder / "q.png", image);
  }
  Planes image{ImageSize{8, 6}};
};

TEST_F(ColourCommand, PaintShowsPickedColoursAndCountsThem) {
  const Ended ended = sir({"paint", "p", "--size", "8x6", "--hue", "350..20", "--saturation",
                           "0.2..0.4", "--with", "1,2,3", "-o", "o.png"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.out, "o.png: 24 of 48 pixels painted (50.00 %)\n");
  const Planes painted = viewer::read_png(folder / "o.png");
  for (std::size_t i = 0; i < 48; ++i)
    ASSERT_EQ(painted.at(i), i < 24 ? (Rgb8{1, 2, 3}) : image.at(i)) << i;
}

TEST_F(ColourCommand, PaintTakesSeveralRulesAndGreysTheRest) {
  const Ended ended =
      sir({"paint", "q.png", "-o", "o.png", "--rule", "h=200..300 with=hue:120", "--rule",
           "v=1 with=9,9,9", "--value", "0.5..0.8", "--with", "keep", "--rest", "grey", "--json"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  // The rule of the single options comes first: 200/255 lies within 0.5..0.8.
  EXPECT_EQ(json::parse(ended.out), json::parse(R"({"pixels":48,"painted":36,"rules":[12,0,24]})"));
  const Planes painted = viewer::read_png(folder / "o.png");
  EXPECT_EQ(painted.at(0), (Rgb8{9, 9, 9}));
  EXPECT_EQ(painted.at(30), (Rgb8{0, 0, 200}));
  EXPECT_EQ(painted.at(40), (Rgb8{100, 100, 100}));
}

TEST_F(ColourCommand, PaintingNothingIsNoError) {
  const Ended ended = sir({"paint", "q.png", "--hue", "90..150", "--with", "0,0,0", "-o", "o.png"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.out, "o.png: 0 of 48 pixels painted (0.00 %)\n");
  EXPECT_EQ(viewer::read_png(folder / "o.png"), image);
}

TEST_F(ColourCommand, PaintNamesWrongOptions) {
  const auto files = folder.list();
  for (const auto& [words, named] : std::vector<std::pair<Names, const char*>>{
           {{}, "--with"},
           {{"--with", "0,0,0"}, "--with"},
           {{"--hue", "1..2"}, "--with"},
           {{"--rule", "s=0.1 with=keep", "--hue", "1..2"}, "--with"},
           {{"--hue", "1..361", "--with", "keep"}, "--hue"},
           {{"--hue", "red", "--with", "keep"}, "--hue"},
           {{"--saturation", "0.6..0.3", "--with", "keep"}, "--saturation"},
           {{"--saturation", "", "--with", "keep"}, "--saturation"},
           {{"--value", "30%", "--with", "keep"}, "--value"},
           {{"--value", "0.5", "--with", "0,0,256"}, "--with"},
           {{"--rule", "s=0.1"}, "--rule"},
           {{"--rule", "s=0.1 with=keep", "--rest", "black"}, "--rest"}}) {
    Names all{"paint", "q.png", "-o", "o.png"};
    all.insert(all.end(), words.begin(), words.end());
    const Ended ended = sir(all);
    EXPECT_EQ(ended.exit_code, 2) << ended.err;
    EXPECT_NE(ended.err.find(named), std::string::npos) << ended.err;
  }
  EXPECT_EQ(sir({"paint", "q.png", "--hue", "1", "--with", "keep"}).exit_code, 2);  // no -o
  EXPECT_EQ(folder.list(), files);
}

TEST_F(ColourCommand, PaintNeverOverwritesItsInput) {
  const std::string bytes = folder.read("q.png");
  for (const auto& [input, output] :
       {std::pair("q.png", "q.png"), std::pair("p", "p.R"), std::pair("s", "s.CSG")})
    EXPECT_EQ(
        sir({"paint", input, "--size", "8x6", "--value", "1", "--with", "0,0,0", "-o", output})
            .exit_code,
        1)
        << output;
  EXPECT_EQ(folder.read("q.png"), bytes);
  expect_failure(sir({"paint", "none.png", "--value", "1", "--with", "0,0,0", "-o", "o.png"}),
                 "none.png");
}

// A picture of more than 256 colours in both grids.
void write_ramp(const std::filesystem::path& path) {
  Planes ramp(ImageSize{64, 48});
  for (std::size_t i = 0; i < ramp.size.pixels(); ++i)
    ramp.set(i, {static_cast<std::uint8_t>(i % 64 * 4), static_cast<std::uint8_t>(i / 64 * 5),
                 static_cast<std::uint8_t>(i % 97)});
  viewer::write_rgb_png(path, ramp);
}

const json& row_of(const json& image, const std::string& choice) {
  for (const json& row : image["rows"])
    if (row["choice"] == choice) return row;
  throw std::runtime_error("no row " + choice);
}

TEST_F(ColourCommand, CostHasARowForEveryChoice) {
  write_ramp(folder / "ramp.png");
  const Ended ended = sir({"cost", "ramp.png", "p", "--size", "8x6", "--repeats", "2", "--json"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const json images = json::parse(ended.out)["images"];
  ASSERT_EQ(images.size(), 2u);
  EXPECT_EQ(images[0]["image"], "ramp.png");
  EXPECT_EQ(images[1]["image"], "p");
  for (const char* choice :
       {"frequency rgb", "frequency hsv", "median rgb --split pixels", "median rgb --split breadth",
        "median rgb --split longest", "median hsv --split pixels", "median hsv --split breadth",
        "median hsv --split longest", "median hsv --grey-s 0.1 --grey-v 0.1",
        "median hsv --grid 18x15x15", "median hsv --grid 72x60x60", "median hsv --sample 64"})
    for (const json& each : images) EXPECT_GT(row_of(each, choice)["ms"], 0) << choice;

  // A row is what the library gives for that choice.
  const Planes ramp = viewer::read_png(folder / "ramp.png");
  quant::ChooseOptions longest;
  longest.space = quant::Space::rgb;
  longest.split = quant::SplitOrder::longest;
  const quant::Lut lut = quant::choose_lut(ramp, longest);
  double squares = 0;
  for (std::size_t i = 0; i < ramp.size.pixels(); ++i) {
    const Rgb8 a = ramp.at(i), b = quant::seen(lut.entry[quant::nearest_entry(a, lut)]);
    squares += std::pow(a.r - b.r, 2) + std::pow(a.g - b.g, 2) + std::pow(a.b - b.b, 2);
  }
  const double rmse = std::sqrt(squares / (3 * static_cast<double>(ramp.size.pixels())));
  const json& row = row_of(images[0], "median rgb --split longest");
  EXPECT_EQ(row["colours"], quant::occupied_cells(ramp).rgb);
  EXPECT_EQ(row["entries"], 256);
  EXPECT_NEAR(row["rmse"].get<double>(), rmse, 1e-9);
  EXPECT_NEAR(row["psnr"].get<double>(), 20 * std::log10(255 / rmse), 1e-9);
  EXPECT_EQ(row_of(images[1], "frequency rgb")["colours"], 3);
}

TEST_F(ColourCommand, CostAddsTheRowThatIsAskedFor) {
  write_ramp(folder / "ramp.png");
  const Ended usual = sir({"cost", "ramp.png", "--repeats", "1"});
  EXPECT_EQ(usual.exit_code, 0) << usual.err;
  EXPECT_EQ(usual.err, "");
  EXPECT_EQ(usual.out.find("your own"), std::string::npos);
  const Ended own = sir({"cost", "ramp.png", "--repeats", "1", "--grey-s", "0.05", "--grid",
                         "72x60x60", "--sample", "4", "--json"});
  const json rows = json::parse(own.out)["images"][0]["rows"];
  quant::ChooseOptions options;
  options.grid = {72, 60, 60, 0.05, 0.2};
  options.sample = 4;
  const Planes ramp = viewer::read_png(folder / "ramp.png");
  EXPECT_EQ(rows.back()["choice"], "your own: 72x60x60, limits 0.05 0.2, sample 4");
  EXPECT_EQ(rows.back()["colours"], quant::count_for(ramp, options).size());
}

TEST_F(ColourCommand, CostOfAnImageThatTheLutHoldsExactlyIsNoError) {
  Planes black(ImageSize{4, 4});
  viewer::write_rgb_png(folder / "black.png", black);
  const Ended ended = sir({"cost", "black.png", "--repeats", "1", "--json"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const json rows = json::parse(ended.out)["images"][0]["rows"];
  for (const json& row : rows) {
    EXPECT_TRUE(row["psnr"].is_null());
    EXPECT_EQ(row["rmse"], 0);
  }
}

TEST_F(ColourCommand, CostRefusesWhatItCannotUse) {
  expect_failure(sir({"cost", "none"}), "none");
  expect_failure(sir({"cost", "q.png", "none.png"}), "none.png");
  for (const Names& words :
       {Names{"cost"}, Names{"cost", "q.png", "--repeats", "0"},
        Names{"cost", "q.png", "--grid", "36"}, Names{"cost", "q.png", "--grey-s", "2"},
        Names{"cost", "q.png", "--sample", "0"}})
    EXPECT_EQ(sir(words).exit_code, 2);
}

TEST_F(ColourCommand, CostCanBeInterrupted) {
  write_ramp(folder / "ramp.png");
  Start start;
  start.folder = folder.path();
  start.err_is_terminal = true;
  if (!terminals_exist()) GTEST_SKIP() << "no terminal to show progress on";
  Program program(SIR_PROGRAM, {"cost", "ramp.png", "--repeats", "1000"}, start);
  ASSERT_TRUE(program.wait_for(" %,"));
  program.signal(SIGINT);
  const Ended ended = program.finish();
  EXPECT_EQ(ended.exit_code, 130);
  EXPECT_EQ(ended.out, "");
}

}  // namespace
}  // namespace sir::test
