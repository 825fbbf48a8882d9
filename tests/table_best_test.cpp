// The method best beside Table 4.1: what the other commands make, and nothing of the thesis moved.
#include <nlohmann/json.hpp>

#include "tests/cli_fixture.h"
#include "tracer/planes.h"

namespace sir::test {
namespace {

using nlohmann::json;

constexpr const char* kNames[] = {"whitted", "calice", "luminar", "piramide", "lcg"};

class TableOfBest : public CliTest {
 protected:
  // Slopes of different colours, with more of them than a LUT has entries.
  TableOfBest() {
    std::filesystem::create_directory(folder / "p");
    for (std::size_t n = 0; n < 5; ++n) {
      Planes planes(ImageSize{640, 480});
      for (std::size_t i = 0; i < planes.size.pixels(); ++i)
        planes.set(i, {static_cast<std::uint8_t>(i % 640 / 10 * 4),
                       static_cast<std::uint8_t>(i / 640 / 8 * (n + 1) % 256),
                       static_cast<std::uint8_t>(40 * n)});
      write_planes(folder.path() / "p" / kNames[n], planes);
    }
  }
};

TEST_F(TableOfBest, IsWhatTheOtherCommandsMake) {
  const Ended ended = sir({"table", "--planes", "p", "--repeats", "1", "--json"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const json images = json::parse(ended.out)["images"];
  ASSERT_EQ(images.size(), 5u);
  for (const json& image : images) {
    const json& best = image["best"];
    EXPECT_EQ(best["goal"], "perceptual");
    EXPECT_EQ(best["map"], "perceptual");
    EXPECT_EQ(best["effort"], 3);
    EXPECT_GT(best["ms"], 0);
    EXPECT_LT(best["metrics"]["de_mean"], image["hsv"]["metrics"]["de_mean"]);
    for (const auto& [key, value] : best.items()) EXPECT_EQ(key.find("thesis"), key.npos) << key;
    EXPECT_EQ(best["metrics"].size(), image["rgb"]["metrics"].size());
  }
  const std::string base = "p/lcg";
  ASSERT_EQ(sir({"lut", base, "--method", "best", "-o", "a.LUT"}).exit_code, 0);
  ASSERT_EQ(sir({"show", base, "--lut", "a.LUT", "--map", "perceptual", "--crop", "--png", "a.png"})
                .exit_code,
            0);
  const json metrics = json::parse(sir({"metrics", base, "a.png", "--json"}).out);
  for (const auto& [key, value] : metrics.items())
    EXPECT_EQ(images[4]["best"]["metrics"][key], value) << key;
  EXPECT_EQ(images[4]["best"]["colours"], 64 * 60);  // as many as there are steps
}

TEST_F(TableOfBest, StandsApartFromTheThesis) {
  const Ended text = sir({"table", "--planes", "p", "--repeats", "1"});
  ASSERT_EQ(text.exit_code, 0) << text.err;
  const std::size_t table = text.out.find("Table 4.1"), apart = text.out.find("Beyond the thesis");
  ASSERT_NE(apart, std::string::npos) << text.out;
  EXPECT_LT(table, apart);
  EXPECT_EQ(text.out.substr(table, apart - table).find("best"), std::string::npos);
  for (const char* label : {"WHITTED best", "PIRÂMIDE best", "LCG best"})
    EXPECT_NE(text.out.find(label), std::string::npos) << label;
}

}  // namespace
}  // namespace sir::test
