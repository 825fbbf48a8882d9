#include "viewer/rendition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "quant/best.h"
#include "quant/choose.h"
#include "quant/shown_through.h"
#include "tests/random_planes.h"
#include "tests/reason_of.h"
#include "tests/temp_folder.h"

namespace sir::viewer {
namespace {

using testing::HasSubstr;

constexpr ImageSize kSize{40, 30};

class RenditionTest : public testing::Test {
 protected:
  RenditionTest() {
    picture.input = folder / "p.png";
    picture.base = folder / "p";
    picture.planes = test::random_planes(kSize, 7);
  }

  // Everything else follows from LUT and options.
  void expect_shown_by(const quant::Lut& lut, const Rendition& made) const {
    EXPECT_EQ(made.lut, lut);
    EXPECT_EQ(made.indices, quant::map_image(picture.planes, lut, options.map));
    EXPECT_EQ(made.seen, quant::as_seen(kSize, made.indices, lut));
    EXPECT_EQ(made.reserved, options.map.reserved);
    EXPECT_GT(made.choose_ms, 0);
    EXPECT_GT(made.map_ms, 0);
  }

  test::TempFolder folder;
  Picture picture;
  RenditionOptions options;
};

TEST_F(RenditionTest, MakesTheThesisFour) {
  using quant::Space;
  struct Case {
    Method method;
    quant::Method by;
    Space in;
    const char* name;
  };
  for (const Case& c :
       {Case{Method::rgb_frequency, quant::Method::frequency, Space::rgb, "frequency in rgb"},
        Case{Method::rgb_median, quant::Method::median, Space::rgb, "median in rgb"},
        Case{Method::hsv_frequency, quant::Method::frequency, Space::hsv, "frequency in hsv"},
        Case{Method::hsv_median, quant::Method::median, Space::hsv, "median in hsv"}}) {
    quant::ChooseOptions choice;
    choice.method = c.by;
    choice.space = c.in;
    const Rendition made = make_rendition(picture, c.method, options);
    expect_shown_by(quant::choose_lut(picture.planes, choice), made);
    EXPECT_EQ(made.method, c.method);
    EXPECT_EQ(made.lut_name, std::string("chosen by ") + c.name);
  }
}

TEST_F(RenditionTest, MakesTheBest) {
  quant::WeightedColours colours;
  colours.add(picture.planes);
  expect_shown_by(quant::choose_best(colours).lut, make_rendition(picture, Method::best, options));
}

TEST_F(RenditionTest, TheBestLeavesReservedEntriesToOthers) {
  for (const std::size_t i : {0, 7, 255}) options.map.reserved.set(i);
  options.map.by = quant::Goal::perceptual;
  quant::WeightedColours colours;
  colours.add(picture.planes);
  quant::BestOptions best;
  best.reserved = options.map.reserved;
  best.entries = 253;
  const Rendition made = make_rendition(picture, Method::best, options);
  expect_shown_by(quant::choose_best(colours, best).lut, made);
  for (const auto index : made.indices) ASSERT_FALSE(options.map.reserved[index]);
}

TEST_F(RenditionTest, AStopLeavesALessGoodLutOfTheBest) {
  std::stop_source stop;
  stop.request_stop();
  const Rendition made = make_rendition(picture, Method::best, options, stop.get_token());
  expect_shown_by(made.lut, made);
}

TEST_F(RenditionTest, ReadsTheLutBesideTheImageOrTheOneThatWasTold) {
  const quant::Lut lut = quant::choose_lut(picture.planes);
  EXPECT_EQ(lut_file(picture.base, options), std::nullopt);
  quant::write_lut(folder / "p.lut", lut);
  EXPECT_EQ(lut_file(picture.base, options), folder / "p.lut");
  Rendition made = make_rendition(picture, Method::lut_file, options);
  expect_shown_by(lut, made);
  EXPECT_EQ(made.lut_name, "p.lut");

  quant::Lut other = lut;
  other.entry[3] = {1, 2, 3};
  quant::write_lut(folder / "other.LUT", other);
  options.lut = folder / "other.LUT";
  EXPECT_EQ(lut_file(picture.base, options), options.lut);
  made = make_rendition(picture, Method::lut_file, options);
  expect_shown_by(other, made);
  EXPECT_EQ(made.lut_name, "other.LUT");
}

TEST_F(RenditionTest, ALutOfAnotherDacKeepsIt) {
  std::vector<quant::DacCode> codes;
  for (int i = 0; i < 16; ++i)
    codes.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(15 - i), 3});
  const quant::Lut lut = quant::make_lut(codes, {{4, 4, 4}});
  quant::write_lut(folder / "p.LUT", lut);
  const Rendition made = make_rendition(picture, Method::lut_file, options);
  expect_shown_by(lut, made);
  EXPECT_EQ(made.lut.dac, (quant::DacBits{{4, 4, 4}}));
}

TEST_F(RenditionTest, SaysWhatIsWrong) {
  const auto reason = [&] {
    return test::reason_of([&] { (void)make_rendition(picture, Method::lut_file, options); });
  };
  EXPECT_THAT(reason(), HasSubstr("p.LUT: is missing"));
  options.lut = folder / "told.LUT";
  EXPECT_THAT(reason(), HasSubstr("told.LUT"));
  folder.write("told.LUT", "1 2 three\n");
  EXPECT_THAT(reason(), HasSubstr("told.LUT:1"));
  EXPECT_THROW(make_rendition(picture, Method::true_colour, options), std::invalid_argument);
}

}  // namespace
}  // namespace sir::viewer
