// What the readers refuse because of its size, and that reading in pieces changes nothing.
#include "tracer/limits.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/reason_of.h"
#include "tests/temp_folder.h"
#include "tracer/error.h"
#include "tracer/scene_file.h"
#include "tracer/text_file.h"
#include "tracer/utf8.h"

namespace sir::test {
namespace {

// Limits that are the usual ones again afterwards.
class LimitsTest : public testing::Test {
 protected:
  ~LimitsTest() override { set_limits({}); }
  static void set_nodes(std::size_t nodes) {
    Limits changed;
    changed.nodes = nodes;
    set_limits(changed);
  }
};

std::string csg_of(const std::string& text) {
  return reason_of([&] {
    TextFile file("B.CSG", text);
    read_csg(file);
  });
}

TEST_F(LimitsTest, MoreNodesThanTheLimitAreRefusedByTheirNumber) {
  EXPECT_EQ(csg_of("1000000000\n"),
            "B.CSG:1: the file announces 1000000000 nodes; at most 250000 nodes are taken; "
            "--max-nodes N allows more");
  EXPECT_EQ(csg_of("\n250001\n").substr(0, 36), "B.CSG:2: the file announces 250001 n");
  EXPECT_EQ(csg_of("250000\n"), "B.CSG:1: the file announces 250000 nodes and ends after 0");
}

TEST_F(LimitsTest, TheLimitCanBeLifted) {
  set_nodes(2);
  EXPECT_EQ(csg_of("3\n"),
            "B.CSG:1: the file announces 3 nodes; at most 2 nodes are taken; "
            "--max-nodes N allows more");
  // The memory would be 20 gigabytes, were it taken before the nodes come.
  set_nodes(kMostNodes);
  EXPECT_EQ(csg_of("100000000\n"), "B.CSG:1: the file announces 100000000 nodes and ends after 0");
}

TEST_F(LimitsTest, LightsAndSurfacesAreLimitedLikewise) {
  set_nodes(10);
  const auto lights = [](const std::string& count) {
    return reason_of([&] {
      TextFile file("B.LUZ", "0 0 0\n1\n" + count + "\n");
      read_lighting(file);
    });
  };
  EXPECT_EQ(lights("10"), "B.LUZ:3: the file announces 10 lights and ends after 0");
  EXPECT_EQ(lights("11"),
            "B.LUZ:3: the file announces 11 lights; at most 10 lights are taken; "
            "--max-nodes N allows more");
  const auto surfaces = [](const std::string& count) {
    return reason_of([&] {
      TextFile file("B.SUP", count + "\n");
      read_surfaces(file);
    });
  };
  EXPECT_EQ(surfaces("10"), "B.SUP:1: the file announces 10 surfaces and ends after 0");
  EXPECT_EQ(surfaces("11"),
            "B.SUP:1: the file announces 11 surfaces; at most 10 surfaces are taken; "
            "--max-nodes N allows more");
}

TEST(Utf8, FindsWhatIsUnfinished) {
  EXPECT_EQ(unfinished_utf8(""), 0u);
  EXPECT_EQ(unfinished_utf8("a"), 0u);
  EXPECT_EQ(unfinished_utf8("a\xC3"), 1u);
  EXPECT_EQ(unfinished_utf8("\xC3\xA9"), 0u);
  EXPECT_EQ(unfinished_utf8("\xE2\x82"), 2u);
  EXPECT_EQ(unfinished_utf8("\xE2\x82\xAC"), 0u);
  EXPECT_EQ(unfinished_utf8("\xF0\x9F\x98"), 3u);
  EXPECT_EQ(unfinished_utf8("\xF0\x9F\x98\x80"), 0u);
  EXPECT_EQ(unfinished_utf8("\x80\x80\x80\x80"), 0u);  // none of its first bytes is near
}

// All lines of a text, with their numbers.
std::vector<std::string> lines_of(TextFile file) {
  std::vector<std::string> lines;
  for (int i = 0; file.next(); ++i) {
    if (i % 3 == 0) {  // put back, also where a piece ends
      file.put_back();
      EXPECT_FALSE(file.at_end());
      EXPECT_TRUE(file.next());
    }
    lines.push_back(std::to_string(file.line_number()) + " " + std::string(file.line()));
  }
  return lines;
}

// Some megabytes, so that it is read in pieces; every letter stands at every place of a piece's end
// in one file or another.
std::string large_text(std::size_t shift) {
  std::string text(shift, '#');
  while (text.size() < std::size_t{5} << 18) {
    text += "\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80 line";
    text += text.size() % 5 == 0 ? "\r\n" : text.size() % 7 == 0 ? "\n\n \n" : "\n";
  }
  return text;
}

TEST(TextInPieces, IsTheSameAsInMemory) {
  const TempFolder folder;
  for (std::size_t shift = 0; shift < 16; ++shift) {
    std::string text = large_text(shift);
    if (shift % 2 == 1) text += "without an end";
    if (shift % 4 == 2) text.insert(0, "\xEF\xBB\xBF");
    const auto whole = lines_of(TextFile("T", text));
    ASSERT_GT(whole.size(), 50'000u);
    ASSERT_EQ(lines_of(TextFile(folder.write("T", text))), whole) << shift;
  }
}

TEST(TextInPieces, TheLastByteSettlesTheEncoding) {
  const TempFolder folder;
  for (const char* last : {"\xE9", "\xC3", "\xE2\x82", "\xF0\x9F\x98"}) {
    const std::string text = large_text(3) + last;
    const auto lines = lines_of(TextFile(folder.write("T", text)));
    ASSERT_EQ(lines, lines_of(TextFile("T", text)));
    EXPECT_EQ(lines[1].substr(0, 6), "2 \xC3\x83\xC2\xA9");  // ISO-8859-1 from the beginning
  }
}

TEST(TextInPieces, ASmallFileIsReadBeforeAnyoneChangesIt) {
  const TempFolder folder;
  TextFile file(folder.write("T", "one\ntwo\n"));
  folder.write("T", "ONE\nTWO\n");
  ASSERT_TRUE(file.next());
  ASSERT_TRUE(file.next());
  EXPECT_EQ(file.line(), "two");
}

TEST(TextInPieces, AFileAboveTheLimitIsRefused) {
  const TempFolder folder;
  std::string text;
  while (text.size() <= kMaxLine) text += "1\n";
  const auto path = folder.write("T", text);
  std::filesystem::resize_file(path, kMaxFile + 1);  // a hole: takes no space
  EXPECT_EQ(reason_of([&] { TextFile{path}; }),
            path.string() + ": the file is longer than 1073741824 bytes");
}

}  // namespace
}  // namespace sir::test
