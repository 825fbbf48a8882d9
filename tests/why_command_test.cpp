// sir why from outside.
#include <gmock/gmock.h>

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "quant/nearest.h"
#include "quant/shown_through.h"
#include "tests/cli_fixture.h"
#include "tests/random_planes.h"
#include "tracer/planes.h"

namespace sir::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using Names = std::vector<std::string>;

class Why : public CliTest {
 protected:
  Why() {
    render();
    image = read_planes(folder / "s", {64, 48});
  }

  Ended why(const std::string& column, const std::string& row, Names more = {},
            const std::string& input = "s") const {
    more.insert(more.begin(), {"why", input, column, row, "--size", "64x48"});
    return sir(more);
  }

  json told(const std::string& column, const std::string& row, Names more = {},
            const std::string& input = "s") const {
    more.push_back("--json");
    const Ended ended = why(column, row, more, input);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return json::parse(ended.out);
  }

  Planes image;
};

TEST_F(Why, AgreesWithTheLut) {
  const Planes noise = random_planes({64, 48}, 5);  // more colours than entries
  write_planes(folder / "n", noise);
  ASSERT_EQ(sir({"lut", "n", "--size", "64x48", "--space", "rgb", "-o", "rgb.LUT", "-q"}).exit_code,
            0);
  const quant::Lut lut = quant::read_lut(folder / "rgb.LUT");
  const Rgb8 colour = noise.at(30 * 64 + 32);
  const std::uint8_t index = quant::nearest_entry(colour, lut);
  const json found = told("32", "30", {"--method", "median", "--space", "rgb"}, "n");
  EXPECT_EQ(found.at("pixel"), (json{32, 30}));
  EXPECT_EQ(found.at("screen"), (json{480 + 32, 366 + 30}));
  EXPECT_EQ(found.at("true"), (json{colour.r, colour.g, colour.b}));
  EXPECT_EQ(found.at("index"), index);
  EXPECT_EQ(found.at("code"), json(lut.entry[index]));
  EXPECT_EQ(found.at("nearest").at("bytes").at(0).at("index"), index);
  EXPECT_TRUE(found.at("nearest").at("eye").is_null());
  EXPECT_TRUE(found.at("ray").is_null());
  EXPECT_EQ(found.at("group").at("of"), 64 * 48);
  const json& why = found.at("why");
  EXPECT_EQ(why.at("method"), "median in rgb");
  EXPECT_EQ(why.at("plane").at("pixels"), 64 * 48);
  const json& cell = why.at("cell").at("at");
  EXPECT_EQ(cell, (json{colour.r / 8, colour.g / 8, colour.b / 8}));
  std::int64_t left = 64 * 48;
  for (const json& split : why.at("splits")) {
    const bool upper = cell.at(split.at("axis").get<std::size_t>()) > split.at("last");
    EXPECT_EQ(split.at("half"), upper ? "upper" : "lower");
    EXPECT_EQ(split.at("pixels"), left);
    left = split.at(upper ? "upper_pixels" : "lower_pixels");
  }
  EXPECT_EQ(why.at("box").at("pixels"), left);
  EXPECT_LT(left, 64 * 48 / 16);
}

TEST_F(Why, AgreesWithTheTracer) {
  int hits = 0;
  for (const auto& [column, row] :
       {std::pair{"32", "30"}, {"32", "24"}, {"29", "22"}, {"32", "3"}, {"0", "0"}, {"35", "27"}}) {
    const json found = told(column, row);
    EXPECT_EQ(found.at("why").at("own_entry"), true);  // a picture of few colours
    const json& ray = found.at("ray");
    const std::string trace = sir({"trace", "s", column, row, "--size", "64x48"}).out;
    if (!ray.at("hit").get<bool>()) {
      EXPECT_THAT(trace, HasSubstr("leaves the scene"));
      continue;
    }
    ++hits;
    EXPECT_THAT(trace, HasSubstr("node " + ray.at("node").dump() + " " + ray.at("name").dump() +
                                 ", face " + ray.at("face").dump() + ", surface " +
                                 ray.at("surface").dump() + " " + ray.at("surface_name").dump()));
  }
  EXPECT_GE(hits, 2);
  EXPECT_LE(hits, 5);
}

TEST_F(Why, TakesTheLutThatShowTakes) {
  EXPECT_EQ(told("1", "2")["why"]["method"], "median in hsv");
  ASSERT_EQ(sir({"lut", "s", "--size", "64x48", "--method", "frequency", "-q"}).exit_code, 0);
  const json by_file = told("1", "2");
  EXPECT_EQ(by_file["why"]["method"], "LUT file");
  EXPECT_EQ(by_file["why"]["lut"], "s.LUT");
  EXPECT_EQ(told("1", "2", {"--lut", "s.LUT"}), by_file);
  const json by_method = told("1", "2", {"--method", "frequency"});
  EXPECT_EQ(by_method["why"]["method"], "frequency in hsv");
  EXPECT_EQ(by_method["index"], by_file["index"]);
  EXPECT_EQ(told("1", "2", {"--space", "rgb"})["why"]["method"], "median in rgb");
  EXPECT_EQ(told("1", "2", {"--method", "best"})["why"]["method"], "best");
}

TEST_F(Why, MapsAndDithersAsShowDoes) {
  EXPECT_TRUE(told("9", "9", {"--map", "perceptual"})["nearest"]["eye"].is_array());
  const json dithered = told("9", "9", {"--dither", "floyd", "--method", "best"});
  EXPECT_EQ(dithered["dithered"], dithered["index"] != dithered["nearest"]["bytes"][0]["index"]);
}

TEST_F(Why, APngHasNoRay) {
  EXPECT_TRUE(told("3", "4", {}, "s.png")["ray"].is_null());
  const std::string text = why("3", "4", {}, "s.png").out;
  EXPECT_THAT(text, HasSubstr("pixel 3,4 · screen 483,370\n"));
  EXPECT_THAT(text, Not(HasSubstr("ray:")));
  EXPECT_THAT(why("3", "4").out, HasSubstr("ray:"));
}

TEST_F(Why, ASceneInLowerCaseHasItsRay) {
  std::filesystem::rename(folder / "s.CSG", folder / "s.csg");
  EXPECT_FALSE(told("3", "4")["ray"].is_null());
  std::filesystem::remove(folder / "s.csg");
  EXPECT_TRUE(told("3", "4")["ray"].is_null());
}

TEST_F(Why, ABrokenSceneLeavesTheRest) {
  folder.write("s.LUZ", "nonsense\n");
  const Ended ended = why("3", "4");
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.err, HasSubstr("no ray is told: s.LUZ"));
  EXPECT_THAT(ended.out, HasSubstr("why: median in hsv"));
}

TEST_F(Why, RefusesAPixelBeyondTheImage) {
  expect_failure(why("64", "0"), "s: has 64x48 pixels; 64,0 is none of them");
  expect_failure(why("0", "48", {}, "s.png"), "64x48");
  expect_failure(sir({"why", "s", "--size", "64x48", "--", "-1", "0"}), "-1,0 is none of them");
}

TEST_F(Why, RefusesWhatDoesNotGoTogether) {
  for (const Names& wrong : {Names{"why", "s", "1"}, Names{"why", "s", "one", "1"},
                             Names{"why", "s", "1", "1", "--lut", "x.LUT", "--method", "best"},
                             Names{"why", "s", "1", "1", "--lut", "x.LUT", "--space", "rgb"},
                             Names{"why", "s", "1", "1", "--method", "best", "--space", "rgb"},
                             Names{"why", "s", "1", "1", "--method", "octree"}})
    EXPECT_EQ(sir(wrong).exit_code, 2) << wrong.back();
  expect_failure(why("1", "1", {"--lut", "missing.LUT"}), "missing.LUT");
}

}  // namespace
}  // namespace sir::test
