#include "tracer/text_file.h"
#include "tracer/limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/reason_of.h"
#include "tests/temp_folder.h"
#include "tracer/error.h"

namespace sir {
namespace {

using test::reason_of;
using test::TempFolder;

// A number's value, NaN where the token is refused.
double number(std::string_view token) {
  double value = 0;
  return parse_number(token, value) ? value : std::numeric_limits<double>::quiet_NaN();
}

std::int64_t count(std::string_view token) {
  std::int64_t value = 0;
  return parse_count(token, value) ? value : -1;
}

TEST(FoldKeyword, IgnoresCaseAccentsAndSurroundingSpace) {
  const std::string composed = "UNI\xC3\x83O", decomposed = "UNIA\xCC\x83O";
  for (const std::string& word :
       {composed, decomposed, std::string("uni\xC3\xA3o"), std::string("Uniao"),
        std::string("UNIAO"), " \t" + composed + "\r"})
    EXPECT_EQ(fold_keyword(word), "uniao") << word;
  EXPECT_EQ(fold_keyword("INTERSE\xC3\x87\xC3\x83O"), "intersecao");
  EXPECT_EQ(fold_keyword("DIFEREN\xC3\x87"
                         "A"),
            "diferenca");
  EXPECT_EQ(fold_keyword("INTERSEC\xCC\xA7"
                         "A\xCC\x83O"),
            "intersecao");
}

TEST(FoldKeyword, KeepsWordsApart) {
  EXPECT_NE(fold_keyword("UNI AO"), "uniao");
  EXPECT_NE(fold_keyword("CONES"), fold_keyword("CONE"));
  EXPECT_EQ(fold_keyword(" \t "), "");
}

TEST(FoldKeyword, LeavesBrokenUtf8Alone) { EXPECT_EQ(fold_keyword("UNI\xC3O"), "UNI\xC3O"); }

TEST(ParseNumber, TakesDecimalNumbers) {
  EXPECT_EQ(number("1"), 1);
  EXPECT_EQ(number("+1"), 1);
  EXPECT_EQ(number(".5"), 0.5);
  EXPECT_EQ(number("+.5"), 0.5);
  EXPECT_EQ(number("-.5"), -0.5);
  EXPECT_EQ(number("1."), 1);
  EXPECT_EQ(number("1e3"), 1000);
  EXPECT_EQ(number("1E+3"), 1000);
  EXPECT_EQ(number("007"), 7);
  EXPECT_TRUE(std::signbit(number("-0")));
}

TEST(ParseNumber, ReadsTheNearestDouble) {
  EXPECT_EQ(number("0.1"), 0.1);
  EXPECT_EQ(number("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(number("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(number("4.9406564584124654e-324"), std::numeric_limits<double>::denorm_min());
}

TEST(ParseNumber, TooSmallIsZeroTooLargeIsNone) {
  EXPECT_EQ(number("1e-400"), 0);
  EXPECT_TRUE(std::signbit(number("-1e-400")));
  EXPECT_EQ(number("+1e-400"), 0);
  EXPECT_TRUE(std::isnan(number("1e999")));
  EXPECT_TRUE(std::isnan(number("-1e999")));
}

TEST(ParseNumber, RefusesEverythingElse) {
  for (const char* token : {"",     "+",   "-",   ".",   "e5",  "1e",    "+-1",      "-+1",
                            "++1",  "--1", "nan", "NAN", "inf", "-inf",  "infinity", "1,5",
                            "0x10", "1x",  " 1",  "1 ",  "1d3", "1_000", "\xC2\xBD", "nan(0)"})
    EXPECT_TRUE(std::isnan(number(token))) << token;
  EXPECT_TRUE(std::isnan(number(std::string_view("1\0", 2))));
}

TEST(ParseCount, TakesNonNegativeIntegersOnly) {
  EXPECT_EQ(count("0"), 0);
  EXPECT_EQ(count("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
  for (const char* token :
       {"", "-1", "-0", "1.0", "1e2", "9223372036854775808", "0x10", "1 2", "um"})
    EXPECT_EQ(count(token), -1) << token;
}

TEST(InQuotes, IsSafeToShow) {
  EXPECT_EQ(in_quotes("CUBO"), "\"CUBO\"");
  EXPECT_EQ(in_quotes(std::string_view("a\0\x1B[31m\x7F\n", 9)), "\"a??[31m??\"");
  EXPECT_EQ(in_quotes("\xC2\x9B"
                      "31m"),
            "\"?31m\"");
  EXPECT_EQ(in_quotes("UNI\xC3\x83O"), "\"UNI\xC3\x83O\"");
}

TEST(InQuotes, CutsBetweenCharacters) {
  EXPECT_EQ(in_quotes(std::string(40, 'x')), "\"" + std::string(40, 'x') + "\"");
  EXPECT_EQ(in_quotes(std::string(41, 'x')), "\"" + std::string(40, 'x') + "...\"");
  const std::string cut = std::string(39, 'x') + "\xC3\x83" + "yz";
  EXPECT_EQ(in_quotes(cut), "\"" + std::string(39, 'x') + "...\"");
}

TEST(SplitTokens, SplitsAtAnyWhiteSpace) {
  const auto tokens = split_tokens(" \t1\v2 \f 3\r");
  ASSERT_EQ(tokens.size(), 3u);
  EXPECT_EQ(tokens[0], "1");
  EXPECT_EQ(tokens[1], "2");
  EXPECT_EQ(tokens[2], "3");
  EXPECT_TRUE(split_tokens(" \t ").empty());
}

TEST(TextFile, PassesOverBlankLinesAndCountsThem) {
  TextFile file("T", "\n\n a b \r\n\t\r\nc");
  ASSERT_TRUE(file.next());
  EXPECT_EQ(file.line(), "a b");
  EXPECT_EQ(file.line_number(), 3u);
  ASSERT_TRUE(file.next());
  EXPECT_EQ(file.line(), "c");
  EXPECT_EQ(file.line_number(), 5u);
  EXPECT_FALSE(file.next());
}

TEST(TextFile, PutsALineBack) {
  TextFile file("T", "a\nb\n");
  EXPECT_FALSE(file.at_end());
  ASSERT_TRUE(file.next());
  EXPECT_EQ(file.line(), "a");
  file.put_back();
  ASSERT_TRUE(file.next());
  EXPECT_EQ(file.line(), "a");
  ASSERT_TRUE(file.next());
  EXPECT_TRUE(file.at_end());
}

TEST(TextFile, KnowsUtf8Latin1AndTheByteOrderMark) {
  for (const char* text :
       {"UNI\xC3\x83O", "UNI\xC3O", "\xEF\xBB\xBFUNI\xC3\x83O", "\xEF\xBB\xBFUNI\xC3O"}) {
    TextFile file("T", text);
    ASSERT_TRUE(file.next());
    EXPECT_EQ(file.line(), "UNI\xC3\x83O") << text;
  }
  TextFile all("T", "caf\xE9 \xFF\xA0\x80");
  ASSERT_TRUE(all.next());
  EXPECT_EQ(all.line(), "caf\xC3\xA9 \xC3\xBF\xC2\xA0\xC2\x80");
}

TEST(TextFile, ReadsNumbersAndCounts) {
  TextFile file("T", "1 +2\t.5\n\n12\n");
  std::array<double, 3> values{};
  file.read_numbers("numbers", values);
  EXPECT_EQ(values, (std::array<double, 3>{1, 2, 0.5}));
  EXPECT_EQ(file.read_count("count"), 12);
}

TEST(TextFile, SaysWhatIsWrongAndWhere) {
  const auto numbers = [](const char* text) {
    return reason_of([=] {
      std::array<double, 2> values{};
      TextFile("B.CAM", text).read_numbers("window", values);
    });
  };
  EXPECT_EQ(numbers("\n1 2 3"), "B.CAM:2: window: 2 numbers expected, 3 found");
  EXPECT_EQ(numbers("1"), "B.CAM:1: window: 2 numbers expected, 1 found");
  EXPECT_EQ(numbers("1 1,5"), "B.CAM:1: window: \"1,5\" is not a finite number");
  EXPECT_EQ(numbers(""), "B.CAM:1: the file ends where window should stand");
  EXPECT_EQ(numbers("\n\n"), "B.CAM:2: the file ends where window should stand");
  EXPECT_EQ(reason_of([] { TextFile("B.CSG", "-3").read_count("count"); }),
            "B.CSG:1: count: \"-3\" is not a non-negative integer");
  EXPECT_EQ(reason_of([] { TextFile("B.CSG", "3 4").read_count("count"); }),
            "B.CSG:1: count: \"3 4\" is not a non-negative integer");
}

TEST(TextFile, ReadsAFile) {
  const TempFolder folder;
  TextFile file(folder.write("T", "a\n"));
  EXPECT_EQ(file.name(), (folder / "T").string());
  ASSERT_TRUE(file.next());
  EXPECT_EQ(file.line(), "a");
  EXPECT_TRUE(TextFile(folder.write("E", "")).at_end());
}

TEST(TextFile, RefusesLinesAboveTheLimit) {
  const TempFolder folder;
  const std::string longest(kMaxLine, 'x');
  TextFile file(folder.write("T", "\n" + longest + "\n"));
  ASSERT_TRUE(file.next());
  EXPECT_EQ(file.line().size(), longest.size());
  const auto path = folder.write("L", "\n" + longest + "x");
  EXPECT_EQ(reason_of([&] { TextFile{path}; }),
            path.string() + ":2: the line is longer than 1048576 bytes");
}

TEST(TextFile, RefusesALineOfGigabytesWithoutReadingItAll) {
  const TempFolder folder;
  const auto path = folder.write("T", "1\n");
  std::filesystem::resize_file(path, std::uintmax_t{2} << 30);  // a hole: takes no space
  EXPECT_EQ(reason_of([&] { TextFile{path}; }),
            path.string() + ":2: the line is longer than 1048576 bytes");
}

TEST(TextFile, RefusesWhatIsNoFile) {
  const TempFolder folder;
  EXPECT_EQ(reason_of([&] { TextFile{folder.path()}; }), folder.path().string() + ": is a folder");
  EXPECT_EQ(reason_of([&] { TextFile{folder / "none"}; }),
            (folder / "none").string() + ": cannot be read: No such file or directory");
}

}  // namespace
}  // namespace sir
