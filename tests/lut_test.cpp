// The artifact, its file, and what both refuse.
#include "quant/lut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "quant/choose.h"
#include "tracer/error.h"

namespace sir::quant {
namespace {

class LutFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("sir_lut_test_" +
               std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directory(folder_);
    path_ = folder_ / "A.LUT";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& text) const { std::ofstream(path_, std::ios::binary) << text; }

  std::string content() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// The error of reading `text`, after the file's name.
  std::string error_of(const std::string& text) const {
    write(text);
    try {
      read_lut(path_);
    } catch (const FileError& error) {
      return std::string(error.what()).substr(path_.string().size());
    }
    return "no error";
  }

  std::filesystem::path folder_, path_;
};

std::string lines(int count, const std::string& line = "1 2 3\n") {
  std::string text;
  for (int i = 0; i < count; ++i) text += line;
  return text;
}

TEST(DacCode, IsSeenAsTheNearestByte) {
  for (int code = 0; code <= 63; ++code)
    EXPECT_EQ(seen_byte(code), static_cast<int>(std::floor(255.0 * code / 63 + 0.5))) << code;
  EXPECT_EQ(seen({0, 32, 63}), (Rgb8{0, 130, 255}));
}

TEST(MakeLut, RepeatsTheLastColour) {
  const Lut lut = make_lut(std::vector<DacCode>{{1, 2, 3}, {4, 5, 6}});
  EXPECT_EQ(lut.chosen, 2u);
  EXPECT_EQ(lut.entry[0], (DacCode{1, 2, 3}));
  for (std::size_t i = 1; i < 256; ++i) EXPECT_EQ(lut.entry[i], (DacCode{4, 5, 6}));
}

TEST(MakeLut, RefusesNoneAndTooMany) {
  EXPECT_THROW(make_lut({}), std::invalid_argument);
  EXPECT_THROW(make_lut(std::vector<DacCode>(257)), std::invalid_argument);
  EXPECT_EQ(make_lut(std::vector<DacCode>(256)).chosen, 256u);
}

TEST(ChooseLut, RefusesAnImageWithoutPixels) {
  EXPECT_THROW(choose_lut(Planes(ImageSize{0, 0})), FileError);
  EXPECT_THROW(choose_lut(Planes(ImageSize{0, 480})), FileError);
}

TEST(ChooseLut, OneColourFillsTheLut) {
  Planes image(ImageSize{4, 4});
  for (std::size_t i = 0; i < 16; ++i) image.set(i, {255, 0, 0});
  for (const Space space : {Space::rgb, Space::hsv}) {
    ChooseOptions options;
    options.space = space;
    const Lut lut = choose_lut(image, options);
    EXPECT_EQ(lut.chosen, 1u);
    for (const DacCode& entry : lut.entry) EXPECT_EQ(entry, (DacCode{63, 0, 0}));
  }
}

TEST(ChooseLut, TheLimitsMakeGreys) {
  Planes image(ImageSize{2, 1});
  image.set(0, {200, 150, 150});  // S = 1/4
  image.set(1, {0, 0, 102});      // V = 2/5
  ChooseOptions options;
  EXPECT_EQ(choose_lut(image, options).entry[1], (DacCode{0, 0, 26}));
  options.grid.grey_s = 0.25;
  options.grid.grey_v = 0.4;
  const Lut lut = choose_lut(image, options);
  EXPECT_EQ(lut.entry[0], (DacCode{26, 26, 26}));
  EXPECT_EQ(lut.entry[1], (DacCode{50, 50, 50}));
}

TEST(MakeLut, RefusesWhatTheDacHasNot) {
  const DacBits high_colour{{5, 6, 5}};
  EXPECT_EQ(make_lut(std::vector<DacCode>{{31, 63, 31}}, high_colour).dac, high_colour);
  EXPECT_THROW(make_lut(std::vector<DacCode>{{32, 63, 31}}, high_colour), std::invalid_argument);
  EXPECT_THROW(make_lut(std::vector<DacCode>{{0, 0, 0}, {0, 64, 0}}), std::invalid_argument);
  EXPECT_THROW(make_lut(std::vector<DacCode>{{0, 0, 0}}, {{6, 6, 9}}), std::invalid_argument);
}

TEST_F(LutFile, HoldsOneLineForEachEntry) {
  write_lut(path_, make_lut(std::vector<DacCode>{{1, 2, 3}, {63, 0, 10}}));
  EXPECT_EQ(content(), "1 2 3\n" + lines(255, "63 0 10\n"));
}

TEST_F(LutFile, ReadsWhatWasWritten) {
  std::vector<DacCode> colours;
  for (std::uint8_t i = 0; i < 200; ++i)
    colours.push_back({static_cast<std::uint8_t>(i % 64), static_cast<std::uint8_t>(i / 4),
                       static_cast<std::uint8_t>(63 - i % 64)});
  for (const std::size_t count : {1, 2, 3, 199, 200}) {
    const Lut lut = make_lut(std::span(colours).first(count));
    write_lut(path_, lut);
    EXPECT_EQ(read_lut(path_), lut);
  }
}

TEST_F(LutFile, TakesAnyWhiteSpaceAndBlankLines) {
  write("\n \t1\t2  3 \r\n\r\n" + lines(255, "4 05 6\r\n") + "\n\n");
  const Lut lut = read_lut(path_);
  EXPECT_EQ(lut.chosen, 2u);
  EXPECT_EQ(lut.entry[0], (DacCode{1, 2, 3}));
  EXPECT_EQ(lut.entry[255], (DacCode{4, 5, 6}));
}

TEST_F(LutFile, NamesTheLineThatIsWrong) {
  EXPECT_EQ(error_of(lines(255)), ":255: the file ends where entry 255 of 0 to 255 should stand");
  EXPECT_EQ(error_of(""), ":1: the file ends where entry 0 of 0 to 255 should stand");
  EXPECT_EQ(error_of(lines(256) + "\n1 2 3\n"), ":258: more than 256 entries");
  EXPECT_EQ(error_of(lines(9) + "1 64 3\n" + lines(246)),
            ":10: entry 9 of 0 to 255: \"64\" is not an integer from 0 to 63");
  EXPECT_EQ(error_of("0 0 -1\n" + lines(255)),
            ":1: entry 0 of 0 to 255: \"-1\" is not an integer from 0 to 63");
  EXPECT_EQ(error_of("0 1.0 1\n" + lines(255)),
            ":1: entry 0 of 0 to 255: \"1.0\" is not an integer from 0 to 63");
  EXPECT_EQ(error_of("0 x 1\n" + lines(255)),
            ":1: entry 0 of 0 to 255: \"x\" is not an integer from 0 to 63");
  EXPECT_EQ(error_of("0 0 99999999999999999999\n" + lines(255)),
            ":1: entry 0 of 0 to 255: \"99999999999999999999\" is not an integer from 0 to 63");
  EXPECT_EQ(error_of("0 0\n" + lines(255)),
            ":1: entry 0 of 0 to 255: three integers expected, 2 words found");
  EXPECT_EQ(error_of("0 0 0 0\n" + lines(255)),
            ":1: entry 0 of 0 to 255: three integers expected, 4 words found");
  EXPECT_EQ(error_of("0\n" + lines(255)),
            ":1: entry 0 of 0 to 255: three integers expected, 1 word found");
}

const DacBits kDacs[] = {{{5, 6, 5}}, {{4, 4, 4}}, {{8, 8, 8}}, {{3, 3, 2}},
                         {{1, 1, 1}}, {{6, 6, 7}}, {{8, 1, 6}}, {{6, 6, 6}}};

TEST_F(LutFile, ReadsWhatWasWrittenForAnyDac) {
  for (const DacBits& dac : kDacs) {
    std::vector<DacCode> colours;
    for (int i = 0; i < 256; ++i)
      colours.push_back({static_cast<std::uint8_t>(i & dac.max_code(0)),
                         static_cast<std::uint8_t>(~i & dac.max_code(1)),
                         static_cast<std::uint8_t>(i / 3 & dac.max_code(2))});
    for (const std::size_t count : {1, 2, 100, 256}) {
      const Lut lut = make_lut(std::span(colours).first(count), dac);
      write_lut(path_, lut);
      const Lut read = read_lut(path_);
      EXPECT_EQ(read.entry, lut.entry);
      EXPECT_EQ(read.dac, dac);
    }
  }
}

TEST_F(LutFile, NamesTheDacOnlyWhereItIsNotTheMa120s) {
  write_lut(path_, make_lut(std::vector<DacCode>{{1, 2, 3}}, {{5, 6, 5}}));
  EXPECT_EQ(content(), "DAC 5 6 5\n" + lines(256));
  write_lut(path_, make_lut(std::vector<DacCode>{{1, 2, 3}}, {{6, 6, 6}}));
  EXPECT_EQ(content(), lines(256));
}

TEST_F(LutFile, ReadsTheDacInAnyCaseAndAmongBlanks) {
  write("\r\n  dac\t5 06  5 \r\n\n" + lines(256, "31 63 31\n"));
  const Lut lut = read_lut(path_);
  EXPECT_EQ(lut.dac, (DacBits{{5, 6, 5}}));
  EXPECT_EQ(lut.chosen, 1u);
  EXPECT_EQ(lut.seen(0), (Rgb8{255, 255, 255}));
  write("Dac 6 6 6\n" + lines(256, "63 63 63\n"));
  EXPECT_EQ(read_lut(path_).dac, DacBits{});
}

TEST_F(LutFile, NamesWhatIsWrongWithTheDac) {
  for (const char* bad : {"0", "9", "-6", "6.0", "six", "99999999999999999999"})
    EXPECT_EQ(error_of("DAC 5 " + std::string(bad) + " 5\n" + lines(256)),
              ":1: DAC: \"" + std::string(bad) + "\" is not a number of bits from 1 to 8");
  EXPECT_EQ(error_of("DAC\n" + lines(256)),
            ":1: DAC: the bits of three primaries expected, 0 words found");
  EXPECT_EQ(error_of("\nDAC 6\n" + lines(256)),
            ":2: DAC: the bits of three primaries expected, 1 word found");
  EXPECT_EQ(error_of("DAC 5 6 5 8\n" + lines(256)),
            ":1: DAC: the bits of three primaries expected, 4 words found");
  // The codes are those of the DAC that is named, primary by primary.
  EXPECT_EQ(error_of("DAC 5 6 4\n" + lines(3) + "32 0 0\n" + lines(252)),
            ":5: entry 3 of 0 to 255: \"32\" is not an integer from 0 to 31");
  EXPECT_EQ(error_of("DAC 5 6 4\n" + lines(3) + "31 64 0\n" + lines(252)),
            ":5: entry 3 of 0 to 255: \"64\" is not an integer from 0 to 63");
  EXPECT_EQ(error_of("DAC 5 6 4\n" + lines(3) + "31 63 16\n" + lines(252)),
            ":5: entry 3 of 0 to 255: \"16\" is not an integer from 0 to 15");
  EXPECT_EQ(error_of("DAC 8 8 8\n" + lines(255) + "0 256 0\n"),
            ":257: entry 255 of 0 to 255: \"256\" is not an integer from 0 to 255");
  EXPECT_EQ(error_of("DAC 5 6 5\n"), ":1: the file ends where entry 0 of 0 to 255 should stand");
  EXPECT_EQ(error_of("DAC 5 6 5\n" + lines(257)), ":258: more than 256 entries");
  // It stands before the entries, once.
  EXPECT_EQ(error_of("DAC 5 6 5\nDAC 5 6 5\n" + lines(256)),
            ":2: entry 0 of 0 to 255: three integers expected, 4 words found");
  EXPECT_EQ(error_of(lines(256) + "DAC 5 6 5\n"), ":257: more than 256 entries");
}

TEST_F(LutFile, MissingFileOrFolder) {
  EXPECT_THROW(read_lut(path_), FileError);
  EXPECT_THROW(write_lut(folder_ / "none" / "A.LUT", Lut{}), FileError);
}

}  // namespace
}  // namespace sir::quant
