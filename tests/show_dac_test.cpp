// sir show from outside: LUTs of other DACs than the MA120's, and reserved entries.
#include <gmock/gmock.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "quant/lattice.h"
#include "quant/lut.h"
#include "quant/shown_through.h"
#include "tests/cli_fixture.h"
#include "viewer/png_file.h"

namespace sir::test {
namespace {

using testing::HasSubstr;
using Names = std::vector<std::string>;

class ShowDac : public CliTest {
 protected:
  ShowDac() {
    render();
    image = read_planes(folder / "s", kSize);
  }

  /// 256 colours out of the image and, for the rest, of the whole cube.
  quant::Lut lut_for(const quant::DacBits& dac) const {
    std::vector<quant::DacCode> codes;
    for (std::size_t i = 0; i < 128; ++i) {
      codes.push_back(quant::nearest_code(image.at(i * 24), dac));
      const auto byte = [&](std::size_t step) { return static_cast<std::uint8_t>(i * step); };
      codes.push_back(quant::nearest_code({byte(37), byte(91), byte(2)}, dac));
    }
    return quant::make_lut(codes, dac);
  }

  void write(const quant::Lut& lut) const { quant::write_lut(folder / "s.LUT", lut); }

  /// `sir show` of the image's area.
  Ended show(Names more = {}) const {
    more.insert(more.begin(), {"show", "s", "--size", "64x48", "--crop", "--png", "shown.png"});
    return sir(more);
  }
  Planes shown() const { return viewer::read_png(folder / "shown.png"); }

  static constexpr ImageSize kSize{64, 48};
  Planes image;
};

TEST_F(ShowDac, FitsTheLutsDacAndSaysSo) {
  for (const quant::DacBits& dac :
       {quant::DacBits{{5, 6, 5}}, quant::DacBits{{8, 8, 8}}, quant::DacBits{{1, 2, 3}}}) {
    const quant::Lut lut = lut_for(dac);
    write(lut);
    const Ended ended = show();
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const std::string bits = std::to_string(dac.bits[0]) + "," + std::to_string(dac.bits[1]) + "," +
                             std::to_string(dac.bits[2]);
    EXPECT_EQ(ended.err,
              "s: shown through a DAC of " + bits + " bits, which the MA120 did not have\n");
    EXPECT_EQ(shown(), quant::as_seen(kSize, quant::map_exhaustively(image, lut), lut));
    const std::string png = folder.read("shown.png");
    const auto chunk = png.find("sBIT");
    ASSERT_NE(chunk, std::string::npos);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(png[chunk + 4 + c], dac.bits[c]);
    EXPECT_EQ(show({"-q"}).err, "");
  }
}

TEST_F(ShowDac, SaysNothingOfTheMa120sOwn) {
  write(lut_for({}));
  EXPECT_EQ(show().err, "");
  const Planes plain = shown();
  // The same codes under a line that says what is so anyway.
  folder.write("s.LUT", "dac 6 6 6\n" + folder.read("s.LUT"));
  EXPECT_EQ(show().err, "");
  EXPECT_EQ(shown(), plain);
}

TEST_F(ShowDac, RefusesADacThatCannotBe) {
  write(lut_for({{5, 6, 5}}));
  const std::string good = folder.read("s.LUT");
  folder.write("s.LUT", "DAC 5 6 9" + good.substr(good.find('\n')));
  expect_failure(show(), "s.LUT:1: DAC: \"9\" is not a number of bits from 1 to 8");
  folder.write("s.LUT", "DAC 1 6 5" + good.substr(good.find('\n')));
  expect_failure(show(), " is not an integer from 0 to 1");
}

TEST_F(ShowDac, TheBudgetIsThatOfTheLutsDac) {
  for (const quant::DacBits& dac : {quant::DacBits{{5, 6, 5}}, quant::DacBits{{3, 3, 2}}}) {
    write(lut_for(dac));
    EXPECT_EQ(show({"-q"}).exit_code, 0);
    const Ended ended = sir({"metrics", "s.png", "shown.png", "--lut", "s.LUT", "--json"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const auto json = nlohmann::json::parse(ended.out);
    // What is measured on the PNG is what the budget shares out.
    EXPECT_NEAR(json["budget"]["total"].get<double>(), json["de_mean"].get<double>(), 1e-9);
    const auto rmse = json["rmse"].get<double>();
    EXPECT_NEAR(json["budget"]["mse"]["total"].get<double>(), rmse * rmse, 1e-9);
    EXPECT_GE(json["budget"]["mse"]["dac"].get<double>(), -1e-9);
  }
}

TEST_F(ShowDac, ReservedEntriesAreTakenByNothing) {
  quant::Lut lut = lut_for({});
  lut.entry[20] = {0, 0, 0};
  write(lut);
  quant::IndexSet reserved;
  ASSERT_TRUE(quant::parse_indices("0-60,200", reserved));
  const Ended ended = show({"--reserve", "0-60,200"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(shown(), quant::as_seen(kSize, quant::map_exhaustively(image, lut, reserved), lut));
  EXPECT_NE(shown(), quant::shown_through(image, lut));
  // The screen around the image too.
  const Names screen{"show", "s", "--size", "64x48", "--png", "screen.png"};
  Names keeping = screen;
  keeping.insert(keeping.end(), {"--reserve", "0-60,200"});
  const auto corner = [&] { return viewer::read_png(folder / "screen.png").at(0); };
  EXPECT_EQ(sir(screen).exit_code, 0);
  EXPECT_EQ(corner(), (Rgb8{0, 0, 0}));
  EXPECT_EQ(sir(keeping).exit_code, 0);
  EXPECT_EQ(corner(), lut.seen(quant::nearest_entry({0, 0, 0}, lut, reserved)));
  EXPECT_NE(corner(), (Rgb8{0, 0, 0}));
}

TEST_F(ShowDac, WhatCannotBeReservedIsWrongUsage) {
  for (const char* text : {"", "256", "1-", "3-1", "x"}) {
    const Ended ended = show({"--reserve", text});
    EXPECT_EQ(ended.exit_code, 2) << text;
    EXPECT_THAT(ended.err, HasSubstr("--reserve")) << text;
  }
  const Ended all = show({"--reserve", "0-99,100-255"});
  EXPECT_EQ(all.exit_code, 2);
  EXPECT_THAT(all.err, HasSubstr("--reserve: leaves no entry to the image"));
}

}  // namespace
}  // namespace sir::test
