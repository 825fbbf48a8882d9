// Files that mean harm: refused with one line, exit code 1 and little memory.
#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/cli_fixture.h"

namespace sir::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kTwoGigabytes = std::uintmax_t{2} << 30;

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SIR_SANITIZED
#endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SIR_SANITIZED
#endif

#ifdef SIR_SANITIZED
constexpr bool kMemoryIsOurs = false;  // the sanitizer's shadow is most of it
#else
constexpr bool kMemoryIsOurs = true;
#endif

class HostileFiles : public CliTest {
 protected:
  static void expect_cheap(const Ended& ended) {
    if (!kMemoryIsOurs) return;
    EXPECT_LT(ended.peak_kilobytes, 100'000) << ended.err;
  }

  void expect_refusal(const std::vector<std::string>& arguments, const std::string& reason,
                      const Start& start = {}) const {
    const Ended ended = sir(arguments, start);
    expect_failure(ended, reason);
    expect_cheap(ended);
  }

  // A file that goes on with zeros for gigabytes and takes no room.
  void write_huge(const std::string& name, const std::string& text) const {
    folder.write(name, text);
    fs::resize_file(folder / name, kTwoGigabytes);
  }

  void link(const std::string& name, const std::string& target) const {
    fs::remove(folder / name);
    fs::create_symlink(target, folder / name);
  }
};

TEST_F(HostileFiles, ACountThatNoMemoryHolds) {
  for (const char* count : {"1000000000", "250001", "9223372036854775807"}) {
    folder.write("s.CSG", std::string(count) + "\n");
    expect_refusal({"check", "s"}, "s.CSG:1: the file announces " + std::string(count) +
                                       " nodes; at most 250000 nodes are taken; --max-nodes N");
  }
  // Lifted, the count still costs no memory that the file does not fill.
  folder.write("s.CSG", "100000000\n");
  expect_refusal({"--max-nodes", "100000000", "check", "s"}, "nodes and ends after 0");
  expect_refusal({"check", "s", "--max-nodes", "100000000"}, "nodes and ends after 0");
}

TEST_F(HostileFiles, AsManyNodesAsAreTakenAndTheLastOneWrong) {
  std::string text = "250000\n";
  for (int i = 0; i < 249'999; ++i)  // numbers in no order, which takes most memory
    text += std::to_string(i * 7919LL % 1'000'003) +
            "\na\nPRIMITIVO\nESFERA\n1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
  folder.write("s.CSG", text + "x\n");
  text = {};
  expect_refusal({"check", "s"}, "a node's number: \"x\" is not a non-negative integer");
}

TEST_F(HostileFiles, LinesOfGigabytes) {
  for (const char* name : {"s.CSG", "s.CAM", "s.LUZ", "s.SUP"}) {
    const std::string whole = folder.read(name);
    write_huge(name, whole);
    expect_refusal({"check", "s"}, "the line is longer than 1048576 bytes");
    folder.write(name, whole);
  }
  write_huge("a.model", "list\n");
  expect_refusal({"model", "a.model"}, "a.model:2: the line is longer than 1048576 bytes");
  write_huge("a.trace", "MA120 trace 1 dac 6 6 6\n");
  expect_refusal({"replay", "a.trace"}, "a.trace:2: the line is longer than 1048576 bytes");
}

TEST_F(HostileFiles, WhatNeverEnds) {
  link("s.CSG", "/dev/zero");
  expect_refusal({"check", "s"}, "s.CSG:1: the line is longer than 1048576 bytes");
  Start zeros;
  zeros.in_file = "/dev/zero";
  expect_refusal({"model", "-"}, "-:1: the line is longer than 65536 bytes", zeros);
  // Short lines without end, through a pipe.
  link("s.CSG", "/dev/stdin");
  Start start;
  start.folder = folder.path();
  Program pipe("/bin/sh", {"-c", "yes 1 | \"$0\" check s", SIR_PROGRAM}, start);
  const Ended ended = pipe.finish();
  expect_failure(ended, "s.CSG: the file is longer than 67108864 bytes");
  expect_cheap(ended);
  for (const char* name : {"s.R", "s.G", "s.B"}) link(name, "/dev/zero");
  expect_refusal({"lut", "s"}, "s.R: cannot be read");
}

TEST_F(HostileFiles, AFolderInAFilesPlace) {
  fs::remove(folder / "s.CSG");
  fs::create_directory(folder / "s.CSG");
  expect_refusal({"check", "s"}, "s.CSG");
  fs::create_directory(folder / "x.png");
  expect_refusal({"lut", "x.png"}, "x.png");
}

TEST_F(HostileFiles, TooManyPixels) {
  const Ended ended = sir({"render", "s", "--size", "1000000x1000000"});
  EXPECT_EQ(ended.exit_code, 2);
  const Ended large = sir({"render", "s", "--size", "10001x10000"});
  EXPECT_EQ(large.exit_code, 2);
  EXPECT_NE(large.err.find("at most 100000000 pixels are taken; --max-pixels N allows more"),
            std::string::npos)
      << large.err;
  // An option that comes after still holds.
  EXPECT_EQ(sir({"render", "s", "--size", "64x48", "--max-pixels", "3071"}).exit_code, 2);
  EXPECT_EQ(sir({"render", "s", "--size", "64x48", "--max-pixels", "3072"}).exit_code, 0);
  expect_refusal({"lut", "s.png", "--max-pixels", "3071"},
                 "s.png: an image of 64x48 is too large: at most 3071 pixels are taken; "
                 "--max-pixels N allows more");
}

// A PNG with no pixels behind its header; the checksum is the one given.
std::string png_header(const std::string& sizes, const std::string& checksum) {
  using namespace std::string_literals;
  return "\x89PNG\r\n\x1A\n\0\0\0\x0DIHDR"s + sizes + "\x08\x02\0\0\0"s + checksum +
         "\0\0\0\0IDAT\x35\xAF\x06\x1E\0\0\0\0IEND\xAE\x42\x60\x82"s;
}

TEST_F(HostileFiles, PixelsThatAPngCannotHold) {
  using namespace std::string_literals;
  folder.write("million.png", png_header("\0\x0F\x42\x40\0\x0F\x42\x40"s, "\xD3\x0F\xAF\x2A"s));
  expect_refusal({"lut", "million.png"}, "an image of 1000000x1000000 is too large");
  folder.write("large.png", png_header("\0\0\x27\x10\0\0\x27\x10"s, "\x35\x2C\xF5\x70"s));
  expect_refusal({"lut", "large.png"}, "cannot hold 10000x10000 pixels");
}

TEST_F(HostileFiles, ASolidDoubledSixtyTimes) {
  std::string script = "create a sphere 1\ncopy a b\n", left = "a", right = "b";
  for (int i = 0; i < 60; ++i) {
    const std::string number = std::to_string(i);
    script += "combine c" + number + " " + left + " union " + right + "\n";
    script += "copy c" + number + " d" + number + "\n";
    left = "c" + number;
    right = "d" + number;
  }
  folder.write("a.model", script);
  expect_refusal({"model", "a.model"},
                 "a.model:35: \"c16\" would have 262143 nodes; at most 250000 nodes are taken; "
                 "--max-nodes N allows more");
}

TEST_F(HostileFiles, ScriptsThatLoadTheNextOneTwice) {
  for (int i = 0; i < 31; ++i) {
    const std::string next = "script load n" + std::to_string(i + 1) + "\n";
    folder.write("n" + std::to_string(i) + ".model", next + next);
  }
  folder.write("n31.model", "list\n");
  expect_refusal({"model", "n0.model"}, "may lead to at most 1000 more");
  folder.write("n31.model", "script load n32\n");
  folder.write("n32.model", "script load n33\n");
  folder.write("n33.model", "list\n");
  expect_refusal({"model", "n0.model"}, "scripts load each other at most 32 deep");
}

TEST_F(HostileFiles, SurfacesAndLightsToTheLimitAndTheLastOneWrong) {
  const std::string luz = folder.read("s.LUZ");
  std::string text = "0 0 0\n1\n250000\n";
  for (int i = 0; i < 249'999; ++i) text += "1 2 3 1\n";
  folder.write("s.LUZ", text + "1\n");
  text = {};
  expect_refusal({"check", "s"}, "s.LUZ:250003: light 250000");
  folder.write("s.LUZ", luz);
  text = "250000\n";
  for (int i = 0; i < 249'999; ++i) text += std::to_string(i) + "\na\nLISA\n0 0 0 0 0 0 0 0 0 0\n";
  folder.write("s.SUP", text + "x\n");
  text = {};
  expect_refusal({"check", "s"}, "a surface's number: \"x\"");
}

}  // namespace
}  // namespace sir::test
