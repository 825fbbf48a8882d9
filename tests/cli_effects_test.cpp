// `sir effects`, antialiasing and progressive rendering as processes.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli_fixture.h"
#include "tracer/planes.h"
#include "viewer/png_file.h"

namespace sir::test {
namespace {

using nlohmann::json;
using Names = std::vector<std::string>;

TEST_F(CliTest, EffectsSaysWhyAndWhatTheyCost) {
  const Ended text = sir({"effects", "s", "--size", "32x24", "--repeats", "2"});
  ASSERT_EQ(text.exit_code, 0) << text.err;
  EXPECT_NE(text.out.find("nodes 1 caixa, 2 furo; light 1"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("no surface with kt > 0"), std::string::npos);
  EXPECT_NE(text.out.find("not asked for (--antialias)"), std::string::npos);
  EXPECT_NE(text.out.find("the same image"), std::string::npos);

  const Ended ended = sir({"effects", "s", "--size", "32x24", "--repeats", "1", "--json",
                           "--effects", "shadow,texture", "--antialias", "random:2"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const json survey = json::parse(ended.out);
  EXPECT_TRUE(survey["all"]["same_image"]);
  ASSERT_EQ(survey["effects"].size(), 8u);
  for (const auto& effect : survey["effects"]) {
    const bool runs = effect["effect"] == "shadow" || effect["effect"] == "texture";
    EXPECT_EQ(effect["called_for"], runs) << effect;
    EXPECT_EQ(effect.contains("reason"), !runs);
    if (effect["effect"] == "reflection" || effect["effect"] == "antialias") {
      EXPECT_EQ(effect["reason"], "forbidden by --effects");
    }
    if (effect["effect"] == "texture") {
      EXPECT_EQ(effect["nodes"], json::array({2}));
    }
    if (effect["effect"] == "shadow") {
      EXPECT_EQ(effect["lights"], json::array({1}));
    }
  }
  const Ended flat = sir({"effects", "s", "--size", "32x24", "--repeats", "1", "--depth", "1"});
  EXPECT_NE(flat.out.find("--depth 1 leaves no room for it"), std::string::npos) << flat.out;
  EXPECT_EQ(sir({"effects", "s", "--effects", "shadow,glow"}).exit_code, 2);
  EXPECT_NE(sir({"effects", "s", "--effects", "glow"}).err.find("highlight shadow filter"),
            std::string::npos);
  expect_failure(sir({"effects", "absent"}), "absent");
}

TEST_F(CliTest, AntialiasingIsAskedForAndCounted) {
  render();
  const Planes plain = read_planes(folder / "s", {64, 48});
  const auto stats = [&](const Names& more) {
    Names words{"render", "s", "--size", "64x48", "--out", "o", "--stats"};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = sir(words);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return json::parse(ended.out);
  };
  const json none = stats({"--antialias", "none"});
  EXPECT_FALSE(none.contains("antialias"));
  EXPECT_FALSE(none["effects"]["antialias"].get<bool>());
  EXPECT_EQ(read_planes(folder / "o/s", {64, 48}), plain);

  const json usual = stats({"--antialias", "adaptive"});
  const Planes antialiased = read_planes(folder / "o/s", {64, 48});
  EXPECT_NE(antialiased, plain);
  EXPECT_TRUE(usual["effects"]["antialias"].get<bool>());
  EXPECT_EQ(usual["antialias"]["mode"], "adaptive");
  EXPECT_EQ(usual["antialias"]["threshold"], 16);
  EXPECT_EQ(usual["antialias"]["levels"], 2);
  EXPECT_EQ(usual["antialias"]["points"], usual["rays"]["primary"]);
  EXPECT_GT(usual["antialias"]["points"], 65 * 49);
  EXPECT_EQ(usual["antialias"]["divided"].size(), 2u);
  EXPECT_FALSE(usual["antialias"].contains("seed"));
  EXPECT_EQ(stats({"--antialias", "adaptive:16:2"})["antialias"], usual["antialias"]);
  EXPECT_EQ(read_planes(folder / "o/s", {64, 48}), antialiased);
  EXPECT_EQ(stats({"--antialias", "adaptive:255:0"})["antialias"]["points"], 65 * 49);

  const json random = stats({"--antialias", "random:5:77"});
  EXPECT_EQ(random["antialias"],
            json::parse(R"({"mode":"random","samples":5,"seed":77,"points":15360})"));
  EXPECT_EQ(stats({"--antialias", "random"})["antialias"]["samples"], 16);

  // What --effects does not allow is not done, and said.
  const json forbidden = stats({"--antialias", "adaptive", "--effects",
                                "highlight,shadow,filter,reflection,refraction,texture"});
  EXPECT_FALSE(forbidden.contains("antialias"));
  EXPECT_FALSE(forbidden["effects"]["antialias"].get<bool>());
  EXPECT_EQ(read_planes(folder / "o/s", {64, 48}), plain);
  EXPECT_TRUE(stats({"--antialias", "random", "--effects", "antialias"}).contains("antialias"));
}

TEST_F(CliTest, ProgressiveEndsInTheSameFiles) {
  render();
  const std::string png = folder.read("s.png"), red = folder.read("s.R");
  const Ended ended =
      sir({"-v", "render", "s", "--size", "64x48", "--out", "o", "--progressive", "--stats"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(folder.read("o/s.png"), png);
  EXPECT_EQ(folder.read("o/s.R"), red);
  const json stages = json::parse(ended.out)["stages"];
  ASSERT_EQ(stages.size(), 6u);
  EXPECT_EQ(
      stages[0],
      json::parse(R"({"block":16,"refined_only":false,"antialiased":false,"share":0.00390625})"));
  EXPECT_EQ(stages[5]["share"], 1);
  for (const char* said : {"all of 16x16, 0.4 %", "refined to 2x2", "all of 1x1, 100.0 %"})
    EXPECT_NE(ended.err.find(said), std::string::npos) << ended.err;

  const Names smooth{"--size", "64x48", "--antialias", "random:4", "--out"};
  for (const std::string way : {"a", "b"}) {
    Names words{"render", "s"};
    words.insert(words.end(), smooth.begin(), smooth.end());
    words.push_back(way);
    if (way == "b") words.push_back("--progressive");
    EXPECT_EQ(sir(words).exit_code, 0);
  }
  EXPECT_EQ(folder.read("a/s.png"), folder.read("b/s.png"));
  EXPECT_EQ(folder.read("a/s.R"), folder.read("b/s.R"));
}

}  // namespace
}  // namespace sir::test
