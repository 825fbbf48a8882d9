// The five scenes, shown by every method on the MA120, have the frames that they always had.
//
// New rows, after a change that is meant (look at the pictures first):
//   SIR_PRINT_GOLDEN=1 build/release/frame_test --gtest_filter='*KeepTheirFrames*' | grep '{"'
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "eltek/display_driver.h"
#include "quant/best.h"
#include "quant/choose.h"
#include "quant/nearest.h"
#include "tests/frame_golden.h"
#include "tests/temp_folder.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"
#include "viewer/png_file.h"

namespace sir::test {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, FrameHashes> kGolden{
    {"whitted-frequency-rgb",
     {0x260463FDAAEDCEDAu, 0xAFAC93C65BA0365Fu, 0x6815A1CCB74C9858u, 0x5B068C00FF63AA27u}},
    {"whitted-median-rgb",
     {0x260463FDAAEDCEDAu, 0xBE73F65FEA102559u, 0x4011B2D479F4A18Cu, 0x901C3C540A5CF435u}},
    {"whitted-frequency-hsv",
     {0x260463FDAAEDCEDAu, 0x07542F3A8F101966u, 0xD69E868BDA943002u, 0xE6AADB0B8BBB2BF5u}},
    {"whitted-median-hsv",
     {0x260463FDAAEDCEDAu, 0x09515A1F6AD5F90Au, 0x32F910A096DBC419u, 0xABDDCA096C7CF9AAu}},
    {"whitted-best",
     {0x260463FDAAEDCEDAu, 0xC0A67B1B4ADC8987u, 0xB5E5D2B13237781Fu, 0xCA00EC1D2569CF97u}},
    {"calice-frequency-rgb",
     {0xDE45BEBFC9D89B7Eu, 0x7D5D9B058DEFDC43u, 0x8F6F0DF71779306Cu, 0x77CD526A9117211Bu}},
    {"calice-median-rgb",
     {0xDE45BEBFC9D89B7Eu, 0x4492520B5DE8DBD5u, 0x8C915F2D44507022u, 0x997CA7BFC123AB4Bu}},
    {"calice-frequency-hsv",
     {0xDE45BEBFC9D89B7Eu, 0x6636B00BEF44490Cu, 0x3A2E40B6EB1C5EAAu, 0x7855F47E9D82B9FCu}},
    {"calice-median-hsv",
     {0xDE45BEBFC9D89B7Eu, 0x2EF4B5FA7651B3C3u, 0xB68079BB91DA3779u, 0x0EB49BDFC28E55F9u}},
    {"calice-best",
     {0xDE45BEBFC9D89B7Eu, 0x6326672F7A8E1548u, 0x183F4FAEAB7AC35Bu, 0xBA4E8A6B94FD465Au}},
    {"luminar-frequency-rgb",
     {0x3B34D483C8243F2Eu, 0x80E095F8F28323C0u, 0xCDE4DEC28E34E78Bu, 0x93EF0B33FAA3F0B2u}},
    {"luminar-median-rgb",
     {0x3B34D483C8243F2Eu, 0x3ABED9BFA4874D20u, 0x122FEBD8BBE8E2DEu, 0x6E2EAF7D0536944Du}},
    {"luminar-frequency-hsv",
     {0x3B34D483C8243F2Eu, 0xB9AAF6384E3829C7u, 0x202437728CE59BC3u, 0x96BEF7FF5D9010B5u}},
    {"luminar-median-hsv",
     {0x3B34D483C8243F2Eu, 0xB9AAF6384E3829C7u, 0x202437728CE59BC3u, 0x96BEF7FF5D9010B5u}},
    {"luminar-best",
     {0x3B34D483C8243F2Eu, 0x6606B25F698972BAu, 0xBB1431908933839Cu, 0xF9B6B349F63075CEu}},
    {"piramide-frequency-rgb",
     {0xF892E57A65DB8B5Eu, 0x06919352729285F8u, 0xBF738600C4F65EE3u, 0x37DF57EBC21396EDu}},
    {"piramide-median-rgb",
     {0xF892E57A65DB8B5Eu, 0xCB2EE61343655BFEu, 0xFB886C50802F1388u, 0x82E598B93E3508FBu}},
    {"piramide-frequency-hsv",
     {0xF892E57A65DB8B5Eu, 0xF33846DEA3BDCD68u, 0xC7744572F735B08Cu, 0x8D65D06EA144DF18u}},
    {"piramide-median-hsv",
     {0xF892E57A65DB8B5Eu, 0x98F09F17D838D508u, 0x625ED141CD56F35Au, 0x125EB84D7A85F415u}},
    {"piramide-best",
     {0xF892E57A65DB8B5Eu, 0xF8B4F9BFED4F1B52u, 0x27760F5D907D1A85u, 0xB85D01996AE361FBu}},
    {"lcg-frequency-rgb",
     {0x4B191A6C9EF9D30Au, 0x6FD5522CB5135AECu, 0x4E3B82C300A90068u, 0xF9552238EB5BC918u}},
    {"lcg-median-rgb",
     {0x4B191A6C9EF9D30Au, 0x6FA0CE293D38053Au, 0xF6A5E14B17544D04u, 0x8B4BAC7B633269BAu}},
    {"lcg-frequency-hsv",
     {0x4B191A6C9EF9D30Au, 0xEEDE379F255417D8u, 0x4385C76A903C76F0u, 0xA36BF3EBA0BBF785u}},
    {"lcg-median-hsv",
     {0x4B191A6C9EF9D30Au, 0xB77A82505C20FE18u, 0x95D3614E24C9A38Cu, 0x8605E17AE8B15280u}},
    {"lcg-best",
     {0x4B191A6C9EF9D30Au, 0x340A60ACCA856E8Bu, 0x3FD665658EFECE29u, 0x232AAE1C55E89044u}},
};

struct Choice {
  std::string name;
  quant::Lut (*lut)(const Planes&);
};

template <quant::Method method, quant::Space space>
quant::Lut choose(const Planes& planes) {
  quant::ChooseOptions options;
  options.method = method;
  options.space = space;
  return quant::choose_lut(planes, options);
}

quant::Lut choose_best(const Planes& planes) {
  quant::WeightedColours colours;
  colours.add(planes);
  return quant::choose_best(colours).lut;
}

const std::vector<Choice> kChoices{
    {"frequency-rgb", choose<quant::Method::frequency, quant::Space::rgb>},
    {"median-rgb", choose<quant::Method::median, quant::Space::rgb>},
    {"frequency-hsv", choose<quant::Method::frequency, quant::Space::hsv>},
    {"median-hsv", choose<quant::Method::median, quant::Space::hsv>},
    {"best", choose_best}};

Frame make_frame(const std::string& name, const Planes& planes, const quant::Lut& lut) {
  Frame frame{name, planes, lut, quant::map_to_lut(planes, lut), {}};
  eltek::Ma120 monitor;
  show_image(monitor, {name, planes.size, frame.indices}, lut);
  frame.screen = monitor.scan_out();
  return frame;
}

// Stays behind, for one to look at.
fs::path failures() { return fs::path(testing::TempDir()) / "sir-frames-that-changed"; }

class FrameGolden : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Five, FrameGolden,
                         testing::Values("whitted", "calice", "luminar", "piramide", "lcg"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST_P(FrameGolden, ScenesKeepTheirFramesByEveryMethod) {
  const Planes planes = render(read_scene(fs::path(SIR_IMAGES) / GetParam()), {}).planes;
  ASSERT_EQ(planes.size, (ImageSize{640, 480}));
  for (const Choice& choice : kChoices) {
    const std::string name = GetParam() + ("-" + choice.name);
    const Frame frame = make_frame(name, planes, choice.lut(planes));
    if (std::getenv("SIR_PRINT_GOLDEN") != nullptr) {
      std::cout << "    " << row(name, hashes(frame)) << "\n";
      continue;
    }
    const auto golden = kGolden.find(name);
    ASSERT_NE(golden, kGolden.end()) << name << " has no golden frame";
    const std::string verdict = judge(frame, golden->second, failures());
    EXPECT_TRUE(verdict.empty()) << verdict;
  }
}

// What happens on failure, provoked.
class FrameFailure : public testing::Test {
 protected:
  FrameFailure() {
    Planes planes(ImageSize{64, 48});
    for (std::size_t p = 0; p < planes.size.pixels(); ++p)
      planes.set(p, {static_cast<std::uint8_t>(p * 5), static_cast<std::uint8_t>(p / 13),
                     static_cast<std::uint8_t>(p * p / 7)});
    frame = make_frame("made", planes, quant::choose_lut(planes));
  }

  Planes picture(const std::string& which) const {
    return viewer::read_png(folder / ("made-" + which + ".png"));
  }
  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  TempFolder folder;
  Frame frame;
};

TEST_F(FrameFailure, AFrameAsEverWritesNothing) {
  EXPECT_EQ(judge(frame, hashes(frame), folder.path()), "");
  EXPECT_TRUE(folder.list().empty());
}

TEST_F(FrameFailure, AnotherChoiceOfColoursIsNamedAsSuch) {
  FrameHashes golden = hashes(frame);
  golden.lut ^= 1;
  golden.screen ^= 1;
  const std::string verdict = judge(frame, golden, folder / "new");
  EXPECT_TRUE(has(verdict, "made is no longer the frame that it was")) << verdict;
  EXPECT_TRUE(has(verdict, "The first stage to depart: LUT (quant/, choice).")) << verdict;
  EXPECT_TRUE(has(verdict, "the screen is what the definitions say")) << verdict;
  EXPECT_TRUE(has(verdict, (folder / "new/made-ACTUAL.png").string())) << verdict;
  EXPECT_TRUE(has(verdict, row("made", hashes(frame)))) << verdict;
  EXPECT_EQ(viewer::read_png(folder / "new/made-ACTUAL.png"), to_planes(frame.screen));
  EXPECT_EQ(viewer::read_png(folder / "new/made-PLAIN.png"), to_planes(frame.screen));
  EXPECT_EQ(viewer::read_png(folder / "new/made-DIFF.png"), Planes(ImageSize{1024, 780}));
}

TEST_F(FrameFailure, AWrongScanoutIsFoundByTheDefinitions) {
  const FrameHashes golden = hashes(frame);
  Rgb8& pixel = frame.screen.pixels[frame.screen.offset(500, 380)];
  pixel.g ^= 1;
  const std::string verdict = judge(frame, golden, folder.path());
  EXPECT_TRUE(has(verdict, "The first stage to depart: screen (eltek/).")) << verdict;
  EXPECT_TRUE(has(verdict, "1 pixels should be others; the first, in column 500 and row 380"))
      << verdict;
  EXPECT_EQ(picture("ACTUAL"), to_planes(frame.screen));
  Planes one(ImageSize{1024, 780});
  one.set(380 * 1024 + 500, {96, 96, 96});
  EXPECT_EQ(picture("DIFF"), one);
}

}  // namespace
}  // namespace sir::test
