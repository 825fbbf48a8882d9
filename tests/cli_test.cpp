// The program from outside: what its commands print and write.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "quant/lut.h"
#include "tests/cli_fixture.h"
#include "tracer/planes.h"
#include "viewer/png_file.h"

namespace sir::test {
namespace {

using nlohmann::json;
using Names = std::vector<std::string>;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

Names sorted(Names names) {
  std::sort(names.begin(), names.end());
  return names;
}

const Names kScene{"s.CAM", "s.CSG", "s.LUZ", "s.SUP"};

Names scene_and(const Names& more) {
  Names all = kScene;
  all.insert(all.end(), more.begin(), more.end());
  return sorted(all);
}

TEST_F(CliTest, VersionAndHelpGoToStandardOutput) {
  const Ended version = sir({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_TRUE(version.out.starts_with("sir ")) << version.out;
  EXPECT_EQ(version.err, "");
  const Ended help = sir({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.err, "");
  for (const std::string command :
       {"render", "probe", "hsv", "lut", "show", "metrics", "table", "check", "trace", "planes",
        "export", "paint", "cost", "effects", "replay"}) {
    EXPECT_NE(help.out.find("\n  " + command + " "), std::string::npos) << command;
    const Ended own = sir({command, "--help"});
    EXPECT_EQ(own.exit_code, 0) << command;
    EXPECT_NE(own.out.find("sir " + command), std::string::npos) << own.out;
    EXPECT_EQ(own.err, "") << command;
  }
  EXPECT_EQ(folder.list(), kScene);
}

TEST_F(CliTest, VersionTellsHowTheProgramWasBuilt) {
  std::istringstream lines(sir({"--version"}).out);
  std::string first;
  std::getline(lines, first);
  EXPECT_THAT(first, testing::MatchesRegex("sir [0-9]+\\.[0-9]+\\.[0-9]+"));
  std::map<std::string, std::string> said;
  for (std::string line; std::getline(lines, line);) {
    constexpr std::size_t kColumn = 14;
    ASSERT_GT(line.size(), kColumn) << line;
    said[line.substr(0, line.find_last_not_of(' ', kColumn - 1) + 1)] = line.substr(kColumn);
  }
  ASSERT_EQ(said.size(), 6);
#ifdef __clang__
  EXPECT_THAT(said["build"], testing::HasSubstr("Clang"));
#else
  EXPECT_THAT(said["build"], testing::HasSubstr("GNU " + std::to_string(__GNUC__) + "."));
#endif
  EXPECT_THAT(said["flags"], testing::HasSubstr("-ffp-contract=off"));
#ifdef __SANITIZE_ADDRESS__
  EXPECT_THAT(said["sanitizers"], testing::HasSubstr("address"));
#elif defined(__SANITIZE_THREAD__)
  EXPECT_THAT(said["sanitizers"], testing::HasSubstr("thread"));
#endif
#ifdef SIR_WITH_SDL
  EXPECT_THAT(said["libraries"], testing::HasSubstr("SDL2 2."));
#else
  EXPECT_THAT(said["built without"], testing::HasSubstr("SDL2"));
#endif
  for (const char* library : {"libpng 1.", "lcms2 2.", "utf8proc 2.", "GMP 6.", "Highway "})
    EXPECT_THAT(said["libraries"], testing::HasSubstr(library));
  EXPECT_THAT(said["instructions"], testing::EndsWith(", of this machine, for packets of rays"));
}

TEST_F(CliTest, RenderWritesPlanesAndAPngOfThem) {
  const Ended ended = sir({"render", "s"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(folder.list(), scene_and({"s.B", "s.G", "s.R", "s.png"}));
  const Planes planes = read_planes(folder / "s", {640, 480});
  EXPECT_EQ(viewer::read_png(folder / "s.png"), planes);
  EXPECT_EQ(planes.at(0), (Rgb8{0, 0, 51}));  // the background
  EXPECT_NE(planes.at(240 * 640 + 320), planes.at(0));
}

TEST_F(CliTest, RenderSaysNothingWhenAskedTo) {
  EXPECT_EQ(sir({"render", "s", "--size", "8x8", "-q"}).err, "");
  EXPECT_NE(sir({"-v", "render", "s", "--size", "8x8"}).err, "");
}

TEST_F(CliTest, RenderMakesTheFolderOfTheOutputs) {
  const Ended ended = sir({"render", "s", "--out", "new/deep", "--size", "32x24", "--no-png"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(folder.list(), scene_and({"new"}));
  for (const char* name : {"new/deep/s.R", "new/deep/s.G", "new/deep/s.B"})
    EXPECT_TRUE(folder.has(name)) << name;
  EXPECT_FALSE(folder.has("new/deep/s.png"));
  EXPECT_EQ(folder.read("new/deep/s.R").size(), 32u * 24u);
}

TEST_F(CliTest, RenderOptionsThatDoNotChangeTheImage) {
  render();
  const Planes plain = read_planes(folder / "s", {64, 48});
  for (const Names& more :
       {Names{"--threads", "1"}, Names{"--threads", "5"}, Names{"--engine", "roth"},
        Names{"--effects", "all"}, Names{"--precision", "double", "--past-limit", "zero"}}) {
    Names words{"render", "s", "--size", "64x48", "--out", "o"};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = sir(words);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(read_planes(folder / "o/s", {64, 48}), plain) << more[0] << " " << more[1];
  }
}

TEST_F(CliTest, RenderOptionsThatDo) {
  render();
  const Planes plain = read_planes(folder / "s", {64, 48});
  for (const Names& more :
       {Names{"--depth", "1"}, Names{"--effects", "shadow,highlight"}, Names{"--cutoff", "0.9"}}) {
    Names words{"render", "s", "--size", "64x48", "--out", "o"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(sir(words).exit_code, 0) << more[0];
    EXPECT_NE(read_planes(folder / "o/s", {64, 48}), plain) << more[0];
  }
}

TEST_F(CliTest, ARegionIsThatPartOfTheImage) {
  render();
  const Ended ended =
      sir({"render", "s", "--size", "64x48", "--region", "13,7,40,33", "--out", "part"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const Planes whole = read_planes(folder / "s", {64, 48});
  const Planes part = read_planes(folder / "part/s", {40, 33});
  for (std::size_t j = 0; j < 33; ++j)
    for (std::size_t i = 0; i < 40; ++i)
      ASSERT_EQ(part.at(j * 40 + i), whole.at((j + 7) * 64 + i + 13));
  EXPECT_EQ(viewer::read_png(folder / "part/s.png"), part);
}

TEST_F(CliTest, HesitationIsAPictureAndATableOfNodes) {
  const Ended text = sir({"render", "s", "--size", "64x48", "--hesitation", "fragile.png", "-q"});
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_NE(text.out.find("pixel"), std::string::npos) << text.out;
  const Planes marked = viewer::read_png(folder / "fragile.png");
  EXPECT_EQ(marked.size, (ImageSize{64, 48}));

  const Ended counted =
      sir({"render", "s", "--size", "64x48", "--hesitation", "fragile.png", "--stats"});
  const auto stats = nlohmann::json::parse(counted.out);
  ASSERT_TRUE(stats.contains("hesitation"));
  EXPECT_TRUE(stats["hesitation"]["nodes"].is_array());

  expect_failure(sir({"render", "s", "--hesitation", "s.CSG"}), "input");
  expect_failure(sir({"render", "s", "--hesitation", "s.png"}), "image itself");
}

TEST_F(CliTest, StatsAreJson) {
  const Ended ended = sir({"render", "s", "--size", "64x48", "--stats"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const json stats = json::parse(ended.out);
  EXPECT_EQ(stats["width"], 64);
  EXPECT_EQ(stats["height"], 48);
  EXPECT_EQ(stats["rays"]["primary"], 64 * 48);
  EXPECT_EQ(stats["precision"], "double");
  EXPECT_EQ(stats["formulas"], "robust");
  const Ended plain = sir({"render", "s", "--size", "8x6", "--stats", "--formulas", "textbook"});
  EXPECT_EQ(json::parse(plain.out)["formulas"], "textbook");
  EXPECT_EQ(json::parse(plain.out)["exact_intersections"], 0);
  const Ended wide = sir({"render", "s", "--size", "8x6", "--stats", "--precision", "long-double"});
  EXPECT_EQ(json::parse(wide.out)["precision"], "long-double");
  EXPECT_EQ(stats["primitives"], 2);
  EXPECT_GT(stats["costs"]["envelopes"], 0);
  // Thesis 2.5: one composite, two primitives; a shadow ray leaves one of them.
  const Ended roth = sir({"render", "s", "--size", "8x6", "--stats", "--engine", "roth", "--depth",
                          "1", "--effects", "highlight"});
  ASSERT_EQ(roth.exit_code, 0) << roth.err;
  const json costs = json::parse(roth.out)["costs"];
  EXPECT_EQ(costs["calls"], 48 * 3);
  EXPECT_EQ(costs["combinations"], 48);
  EXPECT_EQ(costs["transformations"], 48 * 2);
  EXPECT_EQ(costs["envelopes"], 0);
  EXPECT_TRUE(stats["effects"]["reflection"].get<bool>());
}

TEST_F(CliTest, TheSceneMayBeNamedByOneOfItsFiles) {
  const Ended ended = sir({"check", "s.CSG"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_NE(ended.out.find("3 nodes"), std::string::npos) << ended.out;
}

TEST_F(CliTest, LutIsWrittenBesideTheImage) {
  render();
  const Ended ended = sir({"lut", "s", "--size", "64x48", "--json"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const json said = json::parse(ended.out);
  for (const char* key : {"cells_rgb", "cells_hsv", "entries", "ms"})
    EXPECT_TRUE(said.contains(key)) << key;
  EXPECT_TRUE(said["ms"].is_object());
  const auto lut = quant::read_lut(folder / "s.LUT");
  EXPECT_EQ(lines_of(folder.read("s.LUT")).size(), 256u);
  EXPECT_EQ(said["entries"], lut.chosen);
  EXPECT_EQ(said["cells_hsv"], said["entries"]);  // few colours: an entry each

  const std::string text = folder.read("s.LUT");
  EXPECT_EQ(sir({"lut", "s.png", "-o", "other.LUT"}).exit_code, 0);
  EXPECT_EQ(folder.read("other.LUT"), text);
  const Ended defaults = sir({"lut", "s.png", "--method", "median", "--space", "hsv"});
  EXPECT_EQ(folder.read("s.LUT"), text);
  EXPECT_NE(defaults.out.find(said["cells_rgb"].dump() + " in the RGB grid"), std::string::npos);
  const Ended other =
      sir({"lut", "s.png", "--method", "frequency", "--space", "rgb", "-o", "f.LUT"});
  EXPECT_EQ(other.exit_code, 0) << other.err;
  EXPECT_NE(folder.read("f.LUT"), text);
}

TEST_F(CliTest, ShowDithersWhereAsked) {
  EXPECT_EQ(sir({"render", "s", "-q"}).exit_code, 0);
  EXPECT_EQ(sir({"lut", "s", "-q"}).exit_code, 0);
  const auto shown = [&](const std::string& dither) {
    EXPECT_EQ(sir({"show", "s", "--crop", "--png", "d.png", "--dither", dither}).exit_code, 0);
    return folder.read("d.png");
  };
  EXPECT_EQ(sir({"show", "s", "--crop", "--png", "plain.png"}).exit_code, 0);
  const std::string plain = folder.read("plain.png"), floyd = shown("floyd");
  EXPECT_EQ(shown("none"), plain);
  EXPECT_NE(floyd, plain);
  EXPECT_NE(shown("blue-noise"), plain);
  EXPECT_NE(shown("blue-noise"), floyd);
  EXPECT_EQ(sir({"show", "s", "--png", "d.png", "--dither", "bayer"}).exit_code, 2);
}

TEST_F(CliTest, ShowWritesTheScreenAsAnIndexedPng) {
  EXPECT_EQ(sir({"render", "s", "-q"}).exit_code, 0);
  const Ended ended = sir({"show", "s", "--png", "screen.png"});
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_EQ(ended.out, "");
  EXPECT_NE(ended.err.find("median in hsv"), std::string::npos) << ended.err;
  EXPECT_EQ(sir({"lut", "s"}).exit_code, 0);
  const Ended with_lut = sir({"show", "s", "--png", "again.png"});
  EXPECT_EQ(with_lut.err, "");
  EXPECT_EQ(folder.read("again.png"), folder.read("screen.png"));
  EXPECT_EQ(sir({"show", "s.png", "--crop", "--png", "crop.png", "--lut", "s.LUT"}).exit_code, 0);

  EXPECT_EQ(folder.read("screen.png")[25], 3);  // colour type of IHDR: palette
  const Planes screen = viewer::read_png(folder / "screen.png");
  const Planes crop = viewer::read_png(folder / "crop.png");
  ASSERT_EQ(screen.size, (ImageSize{1024, 780}));
  ASSERT_EQ(crop.size, (ImageSize{640, 480}));
  bool centred = true;
  for (std::size_t j = 0; j < 480; ++j)
    for (std::size_t i = 0; i < 640; ++i)
      centred &= crop.at(j * 640 + i) == screen.at((j + 150) * 1024 + i + 192);
  EXPECT_TRUE(centred);
}

TEST_F(CliTest, PlanesGoToPngAndBack) {
  render();
  const std::string red = folder.read("s.R");
  EXPECT_EQ(sir({"planes", "s", "--size", "64x48", "-o", "copy.png"}).exit_code, 0);
  EXPECT_EQ(folder.read("copy.png"), folder.read("s.png"));
  const Ended back = sir({"planes", "copy.png", "--out", "new"});
  EXPECT_EQ(back.exit_code, 0) << back.err;
  EXPECT_NE(back.out.find("64x48"), std::string::npos) << back.out;
  EXPECT_EQ(folder.read("new/copy.R"), red);
  // Old planes beside the PNG are no input, and may be written over.
  folder.write("s.R", std::string(64 * 48, 'x'));
  EXPECT_EQ(sir({"planes", "s.png"}).exit_code, 0);
  EXPECT_EQ(folder.read("s.R"), red);
  EXPECT_EQ(read_planes(folder / "new/copy", {64, 48}), read_planes(folder / "s", {64, 48}));
}

TEST_F(CliTest, ProbeAnswersLineByLine) {
  const Ended ended = sir_reading(
      "0.2 0.2 -5 0 0 1\n\n+.2 .2 .5 0 0 -5\r\n5 5 5 0 0 1\n1 1 -1 0 0 2", {"probe", "s"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.out,
            "{\"hits\":[{\"t\":5,\"side\":\"in\",\"node\":1,\"face\":4,\"surface\":1},"
            "{\"t\":6,\"side\":\"out\",\"node\":1,\"face\":5,\"surface\":1}]}\n"
            "{\"hits\":[{\"t\":0.10000000000000001,\"side\":\"out\",\"node\":1,\"face\":4,"
            "\"surface\":1}]}\n"
            "{\"hits\":[]}\n"
            "{\"hits\":[]}\n");
  const Ended single = sir_reading("0.2 0.2 -5 0 0 1\n", {"probe", "s", "--precision", "float"});
  EXPECT_EQ(json::parse(single.out)["hits"][1]["t"], 6);
}

TEST_F(CliTest, ProbeAnswersBadLinesInTheirPlace) {
  const Ended ended =
      sir_reading("nan 0 0 0 0 1\n.2 .2 -5 0 0 1\n1 2 3\n0 0 0 0 0 0\n.2 .2 -5 0 0 1e-320\n" +
                      std::string(100'000, '1') + "\nx",
                  {"probe", "s"});
  EXPECT_EQ(ended.exit_code, 1);
  const auto lines = lines_of(ended.out);
  ASSERT_EQ(lines.size(), 7u);
  for (std::size_t i = 0; i < lines.size(); ++i)
    EXPECT_EQ(json::parse(lines[i]).contains(i == 1 ? "hits" : "error"), true) << lines[i];
}

TEST_F(CliTest, HsvAnswersLineByLine) {
  const Ended ended = sir_reading("255 0 0\n0 0 255\n128 128 128\n\n0 0 0\n", {"hsv"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const auto lines = lines_of(ended.out);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(json::parse(lines[0]), json::parse(R"({"h":0,"s":1,"v":1,"bin":[0,29,29]})"));
  EXPECT_EQ(json::parse(lines[1]), json::parse(R"({"h":240,"s":1,"v":1,"bin":[24,29,29]})"));
  const json grey = json::parse(lines[2]);
  EXPECT_EQ(grey["h"], 0);
  EXPECT_EQ(grey["s"], 0);
  EXPECT_DOUBLE_EQ(grey["v"].get<double>(), 128.0 / 255);
  EXPECT_EQ(grey["grey"], 15);
  EXPECT_FALSE(grey.contains("bin"));
  EXPECT_EQ(json::parse(lines[3])["grey"], 0);
}

TEST_F(CliTest, HsvAnswersBadLinesInTheirPlace) {
  const Ended ended = sir_reading("256 0 0\n1 2 3\n1 2\n1 2 3 4\n-1 0 0\n1.5 0 0\n", {"hsv"});
  EXPECT_EQ(ended.exit_code, 1);
  const auto lines = lines_of(ended.out);
  ASSERT_EQ(lines.size(), 6u);
  for (std::size_t i = 0; i < lines.size(); ++i)
    EXPECT_EQ(json::parse(lines[i]).contains("error"), i != 1) << lines[i];
}

TEST_F(CliTest, CheckAndTraceTellWhatThereIs) {
  const Ended check = sir({"check", "s"});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  for (const char* part :
       {"3 nodes", "1 cube", "1 sphere", "1 difference", "2 described", "1 light"})
    EXPECT_NE(check.out.find(part), std::string::npos) << check.out;
  const Ended trace = sir({"trace", "s", "320", "240"});
  EXPECT_EQ(trace.exit_code, 0) << trace.err;
  for (const char* part :
       {"column 320, row 240", "node 2 \"furo\"", "surface 2 \"xadrez\"", "weight 1"})
    EXPECT_NE(trace.out.find(part), std::string::npos) << trace.out;
  EXPECT_EQ(folder.list(), kScene);
}

TEST_F(CliTest, TableIsTableFourPointOne) {
  std::filesystem::create_directory(folder / "p");
  for (const char* name : {"whitted", "calice", "luminar", "piramide", "lcg"}) {
    Planes planes(ImageSize{640, 480});
    for (std::size_t i = 0; i < planes.size.pixels(); ++i)
      planes.set(i, i % 3 == 0 ? Rgb8{255, 0, 0} : i % 2 == 0 ? Rgb8{} : Rgb8{0, 255, 0});
    write_planes(folder.path() / "p" / name, planes);
  }
  const Ended ended = sir({"table", "--planes", "p", "--repeats", "1", "--json"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const json images = json::parse(ended.out)["images"];
  ASSERT_EQ(images.size(), 5u);
  EXPECT_EQ(images[0]["rgb"]["thesis_colours"], 867);
  EXPECT_EQ(images[4]["hsv"]["thesis_seconds"], 84);
  for (const json& image : images) {
    EXPECT_EQ(image["rgb"]["colours"], 3);
    EXPECT_EQ(image["hsv"]["colours"], 3);
  }
  const Ended text = sir({"table", "--planes", "p", "--repeats", "1"});
  EXPECT_NE(text.out.find("Table 4.1"), std::string::npos) << text.out;
}

TEST_F(CliTest, AnswersComeAtOnceWhenLinesAreTyped) {
  for (const auto& [words, typed, answer] :
       {std::tuple(Names{"hsv"}, "255 0 0\n", "\"bin\":[0,29,29]}\n"),
        std::tuple(Names{"probe", (folder / "s").string()}, "5 5 5 0 0 1\n", "{\"hits\":[]}\n")}) {
    Start start;
    start.in = typed;
    start.keep_in_open = true;
    Program program(SIR_PROGRAM, words, start);
    EXPECT_TRUE(program.wait_for(answer)) << words[0];
    program.signal(SIGINT);
    EXPECT_EQ(program.finish().exit_code, 130) << words[0];
  }
}

}  // namespace
}  // namespace sir::test
