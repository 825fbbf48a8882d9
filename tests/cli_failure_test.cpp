// The program from outside: wrong usage, bad input, broken outputs, Ctrl-C.
#include <sys/resource.h>

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/cli_fixture.h"
#include "viewer/png_file.h"

namespace sir::test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

const Names kScene{"s.CAM", "s.CSG", "s.LUZ", "s.SUP"};

TEST_F(CliTest, WrongUsageExitsWith2AndNamesTheOption) {
  struct Wrong {
    Names words;
    const char* named;
  };
  for (const Wrong& wrong : std::vector<Wrong>{
           {{}, "subcommand"},
           {{"sculpt", "s"}, "sculpt"},
           {{"--frob"}, "--frob"},
           {{"render"}, "BASE"},
           {{"render", "s", "--frob"}, "--frob"},
           {{"render", "s", "t"}, "t"},
           {{"render", "s", "--size"}, "--size"},
           {{"render", "s", "--size", "640"}, "--size"},
           {{"render", "s", "--size", "640X480"}, "--size"},
           {{"render", "s", "--size", "0x480"}, "--size"},
           {{"render", "s", "--size", "-1x480"}, "--size"},
           {{"render", "s", "--size", "99999x99999"}, "--size"},
           {{"render", "s", "--depth", "0"}, "--depth"},
           {{"render", "s", "--depth", "two"}, "--depth"},
           {{"render", "s", "--cutoff", "-1"}, "--cutoff"},
           {{"render", "s", "--cutoff", "nan"}, "--cutoff"},
           {{"render", "s", "--cutoff", "0,1"}, "--cutoff"},
           {{"render", "s", "--past-limit", "one"}, "--past-limit"},
           {{"render", "s", "--threads", "0"}, "--threads"},
           {{"render", "s", "--precision", "half"}, "--precision"},
           {{"render", "s", "--formulas", "best"}, "--formulas"},
           {{"render", "s", "--formulas", "textbook", "--hesitation", "h.png"}, "--hesitation"},
           {{"effects", "s", "--repeats", "0"}, "--repeats"},
           {{"render", "s", "--effects", "shadow,glow"}, "--effects"},
           {{"render", "s", "--effects", ""}, "--effects"},
           {{"render", "s", "--antialias", ""}, "--antialias"},
           {{"render", "s", "--antialias", "blur"}, "--antialias"},
           {{"render", "s", "--antialias", "Adaptive"}, "--antialias"},
           {{"render", "s", "--antialias", "none:1"}, "--antialias"},
           {{"render", "s", "--antialias", "adaptive:"}, "--antialias"},
           {{"render", "s", "--antialias", "adaptive:256"}, "--antialias"},
           {{"render", "s", "--antialias", "adaptive:-1"}, "--antialias"},
           {{"render", "s", "--antialias", "adaptive:16:7"}, "--antialias"},
           {{"render", "s", "--antialias", "adaptive:16:2:1"}, "--antialias"},
           {{"render", "s", "--antialias", "adaptive:1e1"}, "--antialias"},
           {{"render", "s", "--antialias", "random:0"}, "--antialias"},
           {{"render", "s", "--antialias", "random:4097"}, "--antialias"},
           {{"render", "s", "--antialias", "random::1"}, "--antialias"},
           {{"render", "s", "--antialias", "random:4:-1"}, "--antialias"},
           {{"render", "s", "--antialias", "random:4:1:1"}, "--antialias"},
           {{"render", "s", "--antialias", "random:99999999999999999999"}, "--antialias"},
           {{"render", "s", "--progressive", "--no-png"}, "--no-png"},
           {{"render", "s", "--region", "0,0,8"}, "--region"},
           {{"render", "s", "--region", "0,0,0,8"}, "--region"},
           {{"render", "s", "--region", "640,0,1,1"}, "--region"},
           {{"render", "s", "--region", "2147483647,0,2147483647,1"}, "--region"},
           {{"trace", "s", "640", "0"}, "I J"},
           {{"trace", "s", "x", "0"}, "I"},
           {{"trace", "s", "0"}, "J"},
           {{"probe", "s", "--precision", "quad"}, "--precision"},
           {{"lut", "s", "--method", "guess"}, "--method"},
           {{"lut", "s", "--space", "lab"}, "--space"},
           {{"lut", "s", "--split", "x"}, "--split"},
           {{"lut", "s", "--grey-s", "1.5"}, "--grey-s"},
           {{"lut", "s", "--grey-v", "nan"}, "--grey-v"},
           {{"lut", "s", "--grid", "36x30"}, "--grid"},
           {{"lut", "s", "--sample", "0"}, "--sample"},
           {{"show"}, "IMAGE"},
           {{"show", "s", "s", "--png", "x.png"}, "--png"},
           {{"show", "s", "--reserve", "0-256"}, "--reserve"},
           {{"show", "s", "--reserve", "9-3"}, "--reserve"},
           {{"show", "s", "--reserve", "0-255"}, "--reserve"},
           {{"planes", "s", "-o", "a", "--out", "b"}, "-o"},
           {{"table", "--repeats", "0"}, "--repeats"},
           {{"hsv", "file"}, "file"}}) {
    const Ended ended = sir(wrong.words);
    std::string command = "sir";
    for (const std::string& word : wrong.words) command += " " + word;
    EXPECT_EQ(ended.exit_code, 2) << command << "\n" << ended.err;
    EXPECT_NE(ended.err.find(wrong.named), std::string::npos) << command << "\n" << ended.err;
    EXPECT_EQ(ended.out, "") << command;
  }
  EXPECT_EQ(folder.list(), kScene);
}

// A file of the scene with `from` replaced by `to`.
struct Damage {
  const char* file;
  const char* from;
  const char* to;
  const char* said;
};

TEST_F(CliTest, MalformedFilesGiveOneLineAndNoOutput) {
  for (const Damage& damage : std::vector<Damage>{
           {"s.CSG", "3\n\n0", "4\n\n0", "s.CSG:30: the file announces 4 nodes and ends after 3"},
           {"s.CSG", "DIFERENÇA", "SOMA", "s.CSG:6: node 0 \"tudo\": unknown operation \"SOMA\""},
           {"s.CSG", "1\n2\n\n", "1\n5\n\n", "s.CSG:10: node 0 \"tudo\": node 5 is not in"},
           {"s.CSG", "1\n2\n\n", "1\n1\n\n", "s.CSG:10: node 0 \"tudo\": node 1 already belongs"},
           {"s.CSG", "1\n2\n\n", "1\n0\n\n", "s.CSG:10: node 0 \"tudo\": node 0 is not PRIMITIVO"},
           {"s.CSG", "0 0 1 0", "0 0 l 0", "s.CSG:19: node 1 \"caixa\": line 3 of LOCAL_CENA"},
           {"s.CSG", "0 0 1 0", "0 0 nan 0", "\"nan\" is not a finite number"},
           {"s.CSG", "0 0 1 0", "0 0 1e999 0", "\"1e999\" is not a finite number"},
           {"s.CSG", "0 0 1 0", "0 1 0 0", "s.CSG:17: node 1 \"caixa\": LOCAL_CENA is singular"},
           {"s.CSG", "0 0 1 0", "0 0 1 1", "s.CSG:19: node 1 \"caixa\": the fourth column"},
           {"s.CSG", "CUBO\n1", "CUBO\n3", "s.CSG:16: node 1 \"caixa\": surface 3 is not"},
           {"s.CAM", "\n4\n", "\n-4\n", "s.CAM:4: "},
           {"s.CAM", "0 1 0", "1 1 1", "s.CAM:5: the up vector"},
           {"s.LUZ", "5 6 7 1", "5 6 7", "s.LUZ:4: light 1: "},
           {"s.SUP", "LISA\n", "", "s.SUP:5: surface 1 \"azul\": unknown texture"},
           {"s.SUP", "4 4\n", "\xE9\n", "s.SUP:12: surface 2 \"xadrez\": "}}) {
    const std::string good = folder.read(damage.file);
    std::string bad = good;
    bad.replace(bad.find(damage.from), std::string(damage.from).size(), damage.to);
    folder.write(damage.file, bad);
    for (const Names& words : {Names{"check", "s"}, Names{"render", "s", "--out", "o"}}) {
      const Ended ended = sir(words);
      expect_failure(ended, damage.said);
      EXPECT_EQ(ended.out, "");
    }
    EXPECT_EQ(folder.list(), kScene);
    folder.write(damage.file, good);
  }
  for (const char* file : {"s.CSG", "s.CAM", "s.LUZ", "s.SUP"}) {
    const std::string good = folder.read(file);
    folder.write(file, "");
    expect_failure(sir({"check", "s"}), std::string(file) + ":1: the file ends where");
    folder.write(file, good);
  }
}

TEST_F(CliTest, MissingAndImpossibleFilesAreNamed) {
  expect_failure(sir({"check", "none"}), "none.CSG: is missing (looked for none.CSG and none.csg)");
  fs::remove(folder / "s.LUZ");
  for (const Names& words : {Names{"render", "s"}, Names{"check", "s"}, Names{"probe", "s"},
                             Names{"trace", "s", "0", "0"}})
    expect_failure(sir(words), "s.LUZ: is missing (looked for s.LUZ and s.luz)");
  fs::create_directory(folder / "s.LUZ");
  expect_failure(sir({"check", "s"}), "s.LUZ: is a folder");
  expect_failure(sir({"lut", "s"}), "s.R: is missing (looked for s.R and s.r)");
  expect_failure(sir({"lut", "none.png"}), "none.png: cannot be read: No such file or directory");
  expect_failure(sir({"show", "s.CSG.png", "--png", "x.png"}), "s.CSG.png: cannot be read");
  folder.write("no.png", "text");
  expect_failure(sir({"planes", "no.png"}), "no.png: is not a PNG file");
  expect_failure(sir({"table", "--planes", "p"}), "p/whitted.R: is missing");
  EXPECT_EQ(folder.list(), (Names{"no.png", "s.CAM", "s.CSG", "s.LUZ", "s.SUP"}));
}

TEST_F(CliTest, UnreadableFilesAreNamed) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  ASSERT_EQ(::chmod((folder / "s.CAM").c_str(), 0), 0);
  expect_failure(sir({"check", "s"}), "s.CAM: cannot be read: Permission denied");
}

TEST_F(CliTest, AFileNameCannotBreakTheLine) {
  expect_failure(sir({"check", "a\n\x1B[31mb"}), "a??[31mb.CSG: is missing");
}

TEST_F(CliTest, PlanesOfAnotherSizeAreRefused) {
  render();
  expect_failure(sir({"lut", "s"}), "s.R: holds 3072 bytes where an image of 640x480 has 307200");
  expect_failure(sir({"show", "s", "--png", "x.png"}), "--size WxH");
  EXPECT_FALSE(folder.has("s.LUT") || folder.has("x.png"));
}

TEST_F(CliTest, ALineOfTwoGigabytesIsRefusedInLittleMemory) {
  fs::resize_file(folder / "s.CSG", std::uintmax_t{2} << 30);  // a hole: takes no space
  const Ended ended = sir({"check", "s"});
  expect_failure(ended, "s.CSG:31: the line is longer than 1048576 bytes");
  EXPECT_LT(ended.peak_kilobytes, 500'000);
  for (const char* name : {"s.R", "s.G", "s.B", "x.png", "x.LUT"}) folder.write(name, "");
  for (const char* name : {"s.R", "x.png", "x.LUT"})
    fs::resize_file(folder / name, std::uintmax_t{2} << 30);
  for (const Names& words : {Names{"lut", "s"}, Names{"lut", "x.png"}}) {
    const Ended image = sir(words);
    expect_failure(image, words[1] == "s" ? "s.R: holds 2147483648 bytes" : "x.png: is not a PNG");
    EXPECT_LT(image.peak_kilobytes, 500'000);
  }
}

TEST_F(CliTest, AnImageLargerThanTheScreenNeedsCrop) {
  ASSERT_EQ(sir({"render", "s", "--size", "1025x10", "-q"}).exit_code, 0);
  expect_failure(sir({"show", "s.png", "--png", "x.png"}), "--crop");
  EXPECT_FALSE(folder.has("x.png"));
  EXPECT_EQ(sir({"show", "s.png", "--png", "x.png", "--crop", "-q"}).exit_code, 0);
}

TEST_F(CliTest, InputsAreNeverOverwritten) {
  render();
  ASSERT_EQ(sir({"lut", "s.png", "-q"}).exit_code, 0);
  fs::create_symlink("s.png", folder / "link.png");
  struct Refused {
    Names words;
    const char* input;
  };
  for (const Refused& refused :
       std::vector<Refused>{{{"planes", "s.png", "-o", "s.png"}, "s.png"},
                            {{"planes", "s", "--size", "64x48", "-o", "s.R"}, "s.R"},
                            {{"lut", "s.png", "-o", "s.png"}, "s.png"},
                            {{"lut", "s.png", "-o", "./link.png"}, "s.png"},
                            {{"lut", "s", "--size", "64x48", "-o", "s.B"}, "s.B"},
                            {{"show", "s.png", "--png", "s.png"}, "s.png"},
                            {{"show", "link.png", "--png", "s.png"}, "s.png"},
                            {{"show", "s", "--size", "64x48", "--png", "s.G"}, "s.G"},
                            {{"show", "s.png", "--lut", "s.LUT", "--png", "s.LUT"}, "s.LUT"},
                            {{"lut", "s", "--size", "64x48", "-o", "s.CSG"}, "s.CSG"},
                            {{"lut", "s.png", "-o", "s.SUP"}, "s.SUP"},
                            {{"show", "s", "--size", "64x48", "--png", "s.LUZ"}, "s.LUZ"},
                            {{"planes", "s", "--size", "64x48", "-o", "s.CAM"}, "s.CAM"}}) {
    const std::string before = folder.read(refused.input);
    expect_failure(sir(refused.words), "is an input and is not overwritten");
    EXPECT_EQ(folder.read(refused.input), before);
  }
  fs::remove(folder / "s.G");
  fs::create_symlink("s.SUP", folder / "s.G");
  const std::string surfaces = folder.read("s.SUP");
  expect_failure(sir({"render", "s"}), "s.G: is an input and is not overwritten");
  EXPECT_EQ(folder.read("s.SUP"), surfaces);
}

TEST_F(CliTest, OutputsThatCannotBeWrittenAreNamedAndLeaveNothing) {
  render();
  const Names before = folder.list();
  expect_failure(sir({"lut", "s.png", "-o", "none/x.LUT"}), "none/x.LUT: cannot be written");
  expect_failure(sir({"show", "s.png", "--png", "none/x.png", "-q"}), "none/x.png: cannot be");
  expect_failure(sir({"planes", "s", "--size", "64x48", "-o", "none/x.png"}), "none/x.png: ");
  expect_failure(sir({"render", "s", "--out", "s.CSG"}), "s.CSG: cannot be made a folder");
  expect_failure(sir({"lut", "s.png", "-o", "/dev/full"}), "/dev/full: cannot be written");
  expect_failure(sir({"planes", "s", "--size", "64x48", "-o", "/dev/full"}), "/dev/full: ");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  EXPECT_EQ(folder.list(), before);
  fs::create_directory(folder / "s.B.old");
  fs::rename(folder / "s.B", folder / "s.B.old/s.B");
  fs::create_directory(folder / "s.B");
  expect_failure(sir({"render", "s"}), "s.B: cannot be written: Is a directory");
  EXPECT_EQ(folder.read("s.R").size(), 64u * 48u);  // the old image's
}

TEST_F(CliTest, AFullDiskOrAClosedPipeIsReported) {
  render();
  for (const Names& words :
       {Names{"--help"}, Names{"--version"}, Names{"render", "--help"}, Names{"check", "s"},
        Names{"trace", "s", "0", "0"}, Names{"lut", "s.png"}, Names{"lut", "s.png", "--json"},
        Names{"render", "s", "-q", "--size", "8x8", "--stats", "--out", "o"},
        Names{"planes", "s.png", "--out", "o"}, Names{"probe", "s"}, Names{"hsv"}}) {
    Start full, closed;
    full.out_file = "/dev/full";
    closed.out_closed = true;
    full.in = closed.in = "1 2 3\n";
    expect_failure(sir(words, full), "standard output: cannot be written: No space left on device");
    expect_failure(sir(words, closed), "standard output: cannot be written: Broken pipe");
  }
}

TEST_F(CliTest, ALimitOnFileSizesIsReported) {
  rlimit old{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
  rlimit small = old;
  small.rlim_cur = 1000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const Names before = folder.list();
  const Ended ended = sir({"render", "s", "-q", "--size", "64x48"});
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old), 0);
  expect_failure(ended, "cannot be written: File too large");
  EXPECT_EQ(folder.list(), before);
}

// A glass ball that fills the window: every pixel takes hundreds of rays.
void write_glass(const TempFolder& folder) {
  folder.write("g.CSG", "1\n1\nbola\nPRIMITIVO\nESFERA\n1\n9 0 0 0\n0 9 0 0\n0 0 9 0\n0 0 0 1\n");
  folder.write("g.CAM", "4 3\n0 0 0\n0 0 -1\n20\n0 1 0\n");
  folder.write("g.LUZ", "0 0 .2\n.1\n1\n50 60 70 1\n");
  folder.write("g.SUP", "1\n1\nvidro\nLISA\n0 0 0 0 0 0 .9 20 .9 1.5\n");
}

TEST_F(CliTest, CtrlCLeavesNothingAndExitsWith130) {
  if (!terminals_exist()) GTEST_SKIP() << "no terminal to be had (/dev/pts)";
  write_glass(folder);
  const Names before = folder.list();
  Start start;
  start.err_is_terminal = true;
  Program program(SIR_PROGRAM,
                  {"render", (folder / "g").string(), "--size", "8000x6000", "--depth", "9",
                   "--out", (folder / "o").string()},
                  start);
  EXPECT_TRUE(program.wait_for(" s left"));  // progress, and so at work
  program.signal(SIGINT);
  const Ended ended = program.finish();
  EXPECT_EQ(ended.exit_code, 130);
  EXPECT_NE(ended.err.find("g:"), std::string::npos);
  EXPECT_NE(ended.err.find('%'), std::string::npos);
  EXPECT_TRUE(ended.err.ends_with("\r\x1B[K")) << "the line of progress is left";
  fs::remove(folder / "o");  // the folder itself was asked for; it must be empty
  EXPECT_EQ(folder.list(), before);
}

TEST_F(CliTest, CtrlCLeavesThePictureSoFarAndTheOldPlanes) {
  write_glass(folder);
  for (const char* plane : {"g.R", "g.G", "g.B"}) folder.write(plane, "old");
  Program program(SIR_PROGRAM,
                  {"-v", "render", (folder / "g").string(), "--size", "1600x1200", "--depth", "9",
                   "--progressive"},
                  {});
  EXPECT_TRUE(program.wait_for("all of 16x16"));
  program.signal(SIGINT);
  EXPECT_EQ(program.finish().exit_code, 130);
  const Planes picture = viewer::read_png(folder / "g.png");
  ASSERT_EQ(picture.size, (ImageSize{1600, 1200}));
  EXPECT_EQ(picture.at(0), picture.at(15 * 1600 + 1));
  for (const char* plane : {"g.R", "g.G", "g.B"}) EXPECT_EQ(folder.read(plane), "old");
}

TEST_F(CliTest, ProgressIsForTerminalsOnly) {
  if (!terminals_exist()) GTEST_SKIP() << "no terminal to be had (/dev/pts)";
  Start terminal;
  terminal.err_is_terminal = true;
  EXPECT_EQ(sir({"render", "s", "-q"}, terminal).err, "");
  EXPECT_EQ(sir({"render", "s"}).err.find('\r'), std::string::npos);
}

TEST_F(CliTest, PicturesAndReportsReplaceNothingElse) {
  render();
  for (const char* name : {"s.R", "s.LUT", "s.CSG"}) {
    expect_failure(sir({"paint", "s.png", "-o", name, "--hue", "10..20", "--with", "1,2,3"}), name);
    expect_failure(sir({"metrics", "s.png", "s.png", "--heat-map", name}), name);
  }
  std::filesystem::create_directory_symlink(folder.path(), folder / "link");
  for (const std::string& path : {std::string("link/s.png"), (folder / "s.png").string()})
    expect_failure(sir({"render", "s", "--hesitation", path}), "image itself");
  for (const char* name : {"whitted", "calice", "luminar", "piramide", "lcg"})
    for (const char* suffix : {".CSG", ".CAM", ".LUZ", ".SUP"})
      std::filesystem::copy_file(folder / (std::string("s") + suffix),
                                 folder / (std::string(name) + suffix));
  expect_failure(sir({"table", "--images", ".", "--html", "lcg.CSG"}), "is an input");
  expect_failure(sir({"table", "--images", ".", "--html", "link/calice.SUP"}), "is an input");
}

}  // namespace
}  // namespace sir::test
