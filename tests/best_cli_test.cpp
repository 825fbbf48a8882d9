// sir lut --method best and sir show --map perceptual from outside.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "quant/lattice.h"
#include "quant/lut.h"
#include "quant/perceptual_search.h"
#include "quant/shown_through.h"
#include "tests/best_pictures.h"
#include "tests/cli_fixture.h"
#include "viewer/png_file.h"

namespace sir::test {
namespace {

using nlohmann::json;
using quant::DacCode;
using testing::HasSubstr;
using Names = std::vector<std::string>;

class BestCommand : public CliTest {
 protected:
  BestCommand() {
    write("a.png", slopes({40, 30}));
    write("b.png", clusters({30, 20}, 1, 9, 20));
  }
  void write(const char* name, const Planes& image) const {
    viewer::write_rgb_png(folder / name, image);
  }

  /// `sir lut WORDS --method best MORE`.
  Ended best(Names words, const Names& more = {}) const {
    words.insert(words.begin(), "lut");
    words.insert(words.end(), {"--method", "best"});
    words.insert(words.end(), more.begin(), more.end());
    return sir(words);
  }
  quant::Lut lut(const char* name) const { return quant::read_lut(folder / name); }

  void expect_usage(const Names& words, const std::string& named) const {
    const auto files = folder.list();
    const Ended ended = sir(words);
    EXPECT_EQ(ended.exit_code, 2) << ended.err << named;
    EXPECT_THAT(ended.err, HasSubstr(named));
    EXPECT_EQ(folder.list(), files);
  }
};

TEST_F(BestCommand, WrongOptionsAreWrongUsage) {
  for (const auto& [words, named] : std::vector<std::pair<Names, const char*>>{
           {{"--entries", "0"}, "--entries"},
           {{"--entries", "257"}, "--entries"},
           {{"--entries", "many"}, "--entries"},
           {{"--effort", "0"}, "--effort"},
           {{"--effort", "6"}, "--effort"},
           {{"--goal", "beauty"}, "--goal"},
           {{"--bits", "6,6"}, "--bits"},
           {{"--bits", "0,6,6"}, "--bits"},
           {{"--bits", "9,6,6"}, "--bits"},
           {{"--reserve", "0-256"}, "--reserve"},
           {{"--reserve", "0-255"}, "leaves no entry"},
           {{"--reserve", "0-15", "--entries", "241"}, "240 indices"},
           {{"--pin", "64,0,0"}, "64,0,0"},
           {{"--pin", "16,0,0", "--bits", "4,4,4"}, "16,0,0"},
           {{"--pin", "1,2"}, "1,2"},
           {{"--pin", ""}, "--pin"},
           {{"--pin", "1,2,3,4"}, "1,2,3,4"},
           {{"--pin", "-1,2,3"}, "-1,2,3"},
           {{"--pin", "256=1,2,3"}, "256=1,2,3"},
           {{"--pin", "7=1,2,3", "--pin", "7=1,2,3"}, "second"},
           {{"--pin", "7=1,2,3", "--reserve", "7"}, "reserved"},
           {{"--pin", "1,1,1", "--pin", "2,2,2", "--entries", "1"}, "2 pins"},
           {{"--pin", "1,1,1", "--pin", "2,2,2", "--entries", "1", "--from", "f.LUT"}, "2 pins"},
           {{"--mask", "a.png", "--mask", "a.png"}, "--mask"},
           {{"--space", "rgb"}, "--space"},
           {{"--split", "longest"}, "--split"},
           {{"--grey-s", "0.1"}, "--grey-s"},
           {{"--grid", "36x30x30"}, "--grid"},
           {{"--rgb-bits", "6"}, "--rgb-bits"},
           {{"--sample", "2"}, "--sample"}}) {
    Names all{"lut", "a.png", "--method", "best"};
    all.insert(all.end(), words.begin(), words.end());
    expect_usage(all, named);
  }
}

TEST_F(BestCommand, ItsOptionsBelongToItAlone) {
  for (const Names& words : std::vector<Names>{{"--goal", "psnr"},
                                               {"--effort", "3"},
                                               {"--entries", "256"},
                                               {"--bits", "6,6,6"},
                                               {"--pin", "1,2,3"},
                                               {"--reserve", "3"},
                                               {"--protect-hues"},
                                               {"--from", "f.LUT"},
                                               {"--mask", "a.png"}})
    for (const Names& method :
         std::vector<Names>{{}, {"--method", "median"}, {"--method", "frequency"}}) {
      Names all{"lut", "a.png"};
      all.insert(all.end(), method.begin(), method.end());
      all.insert(all.end(), words.begin(), words.end());
      expect_usage(all, words.front());
    }
}

TEST_F(BestCommand, SeveralImagesNeedANameForTheirLut) {
  expect_usage({"lut", "a.png", "b.png", "--method", "best"}, "-o");
  expect_usage({"lut", "a.png", "b.png", "-o", "o.LUT"}, "best");
  expect_usage({"lut", "a.png", "b.png", "-o", "o.LUT", "--method", "best", "--mask", "a.png"},
               "--mask");
  const Ended ended = best({"a.png", "b.png", "-o", "o.LUT"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  quant::WeightedColours colours;
  colours.add(viewer::read_png(folder / "a.png"));
  colours.add(viewer::read_png(folder / "b.png"));
  EXPECT_EQ(lut("o.LUT").entry, quant::choose_best(colours).lut.entry);
}

TEST_F(BestCommand, TellsWhatAMaskLacks) {
  write("small.png", filled({39, 30}, {255, 255, 255}));
  write("red.png", filled({40, 30}, {255, 0, 0}));
  write("black.png", filled({40, 30}, {0, 0, 0}));
  folder.write("text.png", "no picture");
  for (const auto& [mask, reason] :
       {std::pair("small.png", "39x30"), std::pair("red.png", "no grey image"),
        std::pair("black.png", "no pixel"), std::pair("text.png", "text.png"),
        std::pair("none.png", "cannot be read")}) {
    const Ended ended = best({"a.png"}, {"--mask", mask});
    expect_failure(ended, reason);
    expect_failure(ended, mask);
    EXPECT_FALSE(folder.has("a.LUT"));
  }
}

TEST_F(BestCommand, AMaskSaysWhatCounts) {
  const Planes image = viewer::read_png(folder / "a.png");
  Planes mask = filled(image.size, {255, 255, 255});
  std::vector<std::uint8_t> importance(image.size.pixels(), 255);
  for (std::size_t i = 0; i < importance.size() / 2; ++i) {
    importance[i] = i % 3 == 0 ? 100 : 0;
    mask.set(i, {importance[i], importance[i], importance[i]});
  }
  write("mask.png", mask);
  EXPECT_EQ(best({"a.png"}, {"--mask", "mask.png"}).exit_code, 0);
  quant::WeightedColours colours;
  colours.add(image, importance);
  EXPECT_EQ(lut("a.LUT").entry, quant::choose_best(colours).lut.entry);
}

TEST_F(BestCommand, TellsWhatItDidInJson) {
  const Ended ended = best({"a.png"}, {"--json", "--entries", "20"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const json told = json::parse(ended.out);
  const Planes image = viewer::read_png(folder / "a.png");
  const auto cells = quant::occupied_cells(image);
  EXPECT_EQ(told["cells_rgb"], cells.rgb);
  EXPECT_EQ(told["cells_hsv"], cells.hsv);
  EXPECT_EQ(told["entries"], 20);
  EXPECT_NEAR(told["error"].get<double>(), error_of(quant::Goal::perceptual, image, lut("a.LUT")),
              1e-3);
  for (const char* part : {"read", "count", "choose", "write", "total"})
    EXPECT_GE(told["ms"][part].get<double>(), 0) << part;
}

TEST_F(BestCommand, WritesALutFileOfAnyDac) {
  const auto lines = [&] {
    const std::string text = folder.read("a.LUT");
    return std::count(text.begin(), text.end(), '\n');
  };
  EXPECT_EQ(best({"a.png"}).exit_code, 0);
  EXPECT_EQ(lines(), 256);
  for (const char* bits : {"5,6,5", "8,8,8", "1,1,1", "4,4,4"}) {
    const Ended ended = best({"a.png"}, {"--bits", bits});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(lines(), 257) << bits;
    std::string first = std::string("DAC ") + bits + "\n";
    std::replace(first.begin(), first.end(), ',', ' ');
    EXPECT_TRUE(folder.read("a.LUT").starts_with(first)) << bits;
  }
  EXPECT_EQ(best({"a.png"}, {"--bits", "6,6,6"}).exit_code, 0);
  EXPECT_EQ(lines(), 256);
}

TEST_F(BestCommand, WritesTheSameFileTwice) {
  for (const Names& more : std::vector<Names>{
           {}, {"--goal", "psnr", "--effort", "4"}, {"--protect-hues", "--bits", "5,6,5"}}) {
    EXPECT_EQ(best({"a.png"}, more).exit_code, 0);
    const std::string first = folder.read("a.LUT");
    EXPECT_EQ(best({"a.png"}, more).exit_code, 0);
    EXPECT_EQ(folder.read("a.LUT"), first);
  }
}

TEST_F(BestCommand, PinsAndReservesIndices) {
  const Ended ended =
      best({"a.png"}, {"--pin", "63,63,63", "--pin", "200=1,2,3", "--reserve", "0-15,255"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("--reserve"));
  EXPECT_THAT(ended.out, HasSubstr("239 entries"));
  const quant::Lut chosen = lut("a.LUT");
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(chosen.entry[i], DacCode{});
  EXPECT_EQ(chosen.entry[16], (DacCode{63, 63, 63}));
  EXPECT_EQ(chosen.entry[200], (DacCode{1, 2, 3}));
  EXPECT_EQ(chosen.entry[255], DacCode{});
}

TEST_F(BestCommand, StartsFromALutAndDoesNotOverwriteIt) {
  EXPECT_EQ(best({"a.png"}).exit_code, 0);
  const std::string before = folder.read("a.LUT");
  expect_failure(best({"a.png"}, {"--from", "a.LUT"}), "a.LUT");
  expect_failure(best({"b.png", "-o", "./a.LUT"}, {"--from", "a.LUT"}), "a.LUT");
  EXPECT_EQ(folder.read("a.LUT"), before);

  const Ended ended = best({"a.png", "-o", "again.LUT"}, {"--from", "a.LUT"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const Planes image = viewer::read_png(folder / "a.png");
  EXPECT_LE(error_of(quant::Goal::perceptual, image, lut("again.LUT")),
            error_of(quant::Goal::perceptual, image, lut("a.LUT")) * (1 + 1e-6));

  // Its DAC is taken over; another one is refused.
  EXPECT_EQ(best({"a.png", "-o", "amiga.LUT"}, {"--bits", "4,4,4"}).exit_code, 0);
  EXPECT_EQ(best({"b.png", "-o", "next.LUT"}, {"--from", "amiga.LUT"}).exit_code, 0);
  EXPECT_EQ(lut("next.LUT").dac, (quant::DacBits{{4, 4, 4}}));
  expect_failure(best({"b.png"}, {"--from", "amiga.LUT", "--bits", "6,6,6"}), "amiga.LUT");
  expect_failure(best({"b.png"}, {"--from", "amiga.LUT", "--pin", "16,0,0"}), "16,0,0");
  folder.write("bad.LUT", "1 2\n");
  expect_failure(best({"b.png"}, {"--from", "bad.LUT"}), "bad.LUT:1");
  expect_failure(best({"b.png"}, {"--from", "none.LUT"}), "none.LUT");
}

TEST_F(BestCommand, SaysWhichOptionsDoNotGoTogether) {
  write("a.png", random_planes({4, 4}, 1));
  const Ended none_left = best({"a.png"}, {"--reserve", "0-255"});
  EXPECT_EQ(none_left.exit_code, 2);
  EXPECT_THAT(none_left.err, HasSubstr("--reserve: leaves no entry"));
  const Ended reserved = best({"a.png"}, {"--reserve", "3", "--pin", "3=1,1,1"});
  EXPECT_EQ(reserved.exit_code, 2);
  EXPECT_THAT(reserved.err, HasSubstr("--pin"));
  EXPECT_THAT(reserved.err, HasSubstr("3=1,1,1 is at a reserved index"));
}

TEST_F(BestCommand, SaysWhichHuesFoundNoEntry) {
  write("noise.png", random_planes({40, 40}, 1));
  const Ended ended = best({"noise.png"}, {"--protect-hues", "--entries", "8"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1);
  const int grey = ended.err.find("and for grey") != std::string::npos;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), ',') + 1 + grey, 37 - 8);
  EXPECT_THAT(ended.err, HasSubstr("no entry is left for the hue of "));
  EXPECT_EQ(best({"noise.png"}, {"--protect-hues"}).err, "");
}

TEST_F(BestCommand, TakesTheLeastPictures) {
  for (const Rgb8& colour : {Rgb8{0, 0, 0}, Rgb8{255, 255, 255}, Rgb8{255, 130, 0}})
    for (const ImageSize& size : {ImageSize{1, 1}, ImageSize{1, 9}, ImageSize{9, 1}}) {
      write("one.png", filled(size, colour));
      const Ended ended = best({"one.png"});
      EXPECT_EQ(ended.exit_code, 0) << ended.err;
      EXPECT_THAT(ended.out, HasSubstr("1 entry chosen"));
      const quant::Lut chosen = lut("one.LUT");
      EXPECT_EQ(chosen.entry[0], (quant::nearest_code(colour, {})));
      EXPECT_EQ(chosen.chosen, 1u);
    }
}

TEST_F(BestCommand, ShowMapsByTheEye) {
  EXPECT_EQ(best({"a.png"}, {"--entries", "12"}).exit_code, 0);
  const Planes image = viewer::read_png(folder / "a.png");
  const quant::Lut chosen = lut("a.LUT");
  quant::IndexSet reserved;
  for (std::size_t i = 3; i < 7; ++i) reserved.set(i);
  for (const bool reserve : {false, true}) {
    Names words{"show", "a.png", "--map", "perceptual", "--crop", "--png", "shown.png"};
    if (reserve) words.insert(words.end(), {"--reserve", "3-6"});
    const Ended ended = sir(words);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const Planes expected = quant::as_seen(
        image.size, quant::map_perceptually(image, chosen, reserve ? reserved : quant::IndexSet{}),
        chosen);
    EXPECT_EQ(viewer::read_png(folder / "shown.png"), expected);
    EXPECT_NE(expected, quant::shown_through(image, chosen));  // by the bytes
  }
  EXPECT_EQ(sir({"show", "a.png", "--map", "rgb", "--crop", "--png", "shown.png"}).exit_code, 0);
  EXPECT_EQ(viewer::read_png(folder / "shown.png"), quant::shown_through(image, chosen));
  expect_usage({"show", "a.png", "--map", "beauty", "--png", "other.png"}, "--map");
}

}  // namespace
}  // namespace sir::test
