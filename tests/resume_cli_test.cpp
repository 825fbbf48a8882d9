// `sir render` killed in the middle and continued by another, as a person sees it.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>

#include "cli/render_settings.h"
#include "tests/cli_fixture.h"
#include "tests/eventually.h"
#include "tracer/scene_file.h"
#include "tracer/tile_file.h"

namespace sir {
namespace {

using test::Ended;
using test::Program;
using test::Start;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

class Resume : public test::CliTest {
 protected:
  static Words with(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  std::uintmax_t record_size() const {
    std::error_code missing;
    const auto size = std::filesystem::file_size(folder / "out/calice.tiles", missing);
    return missing ? 0 : size;
  }

  // Starts it and sends the signal as soon as the record has more than `size` bytes. A render that
  // is done before has no record any more: its exit code is 0.
  Ended end_by(int number, const Words& arguments, std::uintmax_t size) const {
    Start start;
    start.folder = folder.path();
    Program program(SIR_PROGRAM, arguments, start);
    bool over = false;
    EXPECT_TRUE(test::eventually([&] {
      over = folder.has("out/calice.R");
      return over || record_size() > size;
    }));
    program.signal(number);
    return program.finish();
  }

  void remove_outputs() const { std::filesystem::remove_all(folder / "out"); }

  // Calls `chain` until no render in it was done before it could be interrupted.
  template <typename Chain>
  void interrupted_in_time(Chain chain) const {
    for (int attempt = 0; attempt < 20; ++attempt) {
      remove_outputs();
      if (chain() || HasFatalFailure()) return;
    }
    FAIL() << "was always done before it could be interrupted";
  }

  // Killed, continued, interrupted, continued with other threads: the same bytes.
  void expect_same_bytes(const Words& options) const {
    SCOPED_TRACE(testing::PrintToString(options));
    const Words words =
        with({"render", SIR_IMAGES "/calice", "--out", "out", "--keep-after", "0"}, options);
    ASSERT_EQ(sir(words).exit_code, 0);
    std::vector<std::string> whole;
    for (const char* file : {"R", "G", "B", "png"})
      whole.push_back(folder.read(std::string("out/calice.") + file));
    EXPECT_EQ(record_size(), 0u);
    interrupted_in_time([&] {
      const Ended killed = end_by(SIGKILL, with(words, {"--threads", "2"}), 1000);
      if (killed.exit_code == 0 || folder.has("out/calice.R")) return false;
      EXPECT_EQ(killed.exit_code, 128 + SIGKILL);
      const auto size = record_size();
      const Ended stopped =
          end_by(SIGINT, with(words, {"--threads", "1", "--resume"}), size + 1000);
      if (folder.has("out/calice.R")) return false;
      EXPECT_EQ(stopped.exit_code, 130);
      EXPECT_THAT(stopped.err, HasSubstr("continued from"));
      EXPECT_THAT(stopped.err, HasSubstr("the same command with --resume"));
      EXPECT_GT(record_size(), size);
      const Ended done = sir(with(words, {"--threads", "3", "--resume", "-v"}));
      EXPECT_EQ(done.exit_code, 0) << done.err;
      EXPECT_THAT(done.err, HasSubstr("taken over"));
      EXPECT_THAT(done.err, Not(HasSubstr(": 0 tiles taken over")));
      std::size_t at = 0;
      for (const char* file : {"R", "G", "B", "png"})
        EXPECT_EQ(folder.read(std::string("out/calice.") + file), whole[at++]) << file;
      EXPECT_EQ(record_size(), 0u);
      return true;
    });
  }

  // A record with some tiles in it.
  void leave_record(const Words& options) const {
    const Words words = with({"render", SIR_IMAGES "/calice", "--out", "out"}, options);
    interrupted_in_time([&] {
      return end_by(SIGKILL, with(words, {"--keep-after", "0"}), 1000).exit_code != 0 &&
             !folder.has("out/calice.R");
    });
  }
};

// Long enough on any machine to be ended in the middle, and no longer than needed.
const Words kLong = {"--size", "320x240", "--engine", "roth"};

TEST_F(Resume, Gates) { expect_same_bytes({"--size", "1200x900"}); }
TEST_F(Resume, Roth) { expect_same_bytes(kLong); }
TEST_F(Resume, Envelopes) {
  expect_same_bytes({"--size", "400x300", "--engine", "envelopes", "--region", "13,7,380,290"});
}
TEST_F(Resume, Float) { expect_same_bytes(with(kLong, {"--precision", "float"})); }
TEST_F(Resume, LongDouble) {
  expect_same_bytes({"--size", "160x120", "--engine", "roth", "--precision", "long-double"});
}
TEST_F(Resume, Textbook) { expect_same_bytes(with(kLong, {"--formulas", "textbook"})); }
TEST_F(Resume, Adaptive) {
  expect_same_bytes({"--size", "400x300", "--antialias", "adaptive:4:3"});
}
TEST_F(Resume, Random) { expect_same_bytes({"--size", "160x120", "--antialias", "random:64"}); }
TEST_F(Resume, Progressive) { expect_same_bytes(with(kLong, {"--progressive"})); }
TEST_F(Resume, ProgressiveAdaptive) {
  expect_same_bytes({"--size", "400x300", "--progressive", "--antialias", "adaptive:4:3"});
}

TEST_F(Resume, NoRecordIsRenderedFromTheStart) {
  const Ended ended = sir({"render", "s", "--size", "64x48", "--resume"});
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.err, HasSubstr("no finished tiles"));
  EXPECT_TRUE(folder.has("s.R"));
  EXPECT_FALSE(folder.has("s.tiles"));
}

TEST_F(Resume, WhatDiffersIsToldAndNotContinued) {
  leave_record(kLong);
  const auto size = record_size();
  const Words other = {"render",  SIR_IMAGES "/calice", "--out", "out",     "--size",
                       "320x240", "--engine",           "gates", "--depth", "6"};
  const Ended refused = sir(with(other, {"--resume"}));
  test::expect_failure(refused, "out/calice.tiles: is of another render: ");
  EXPECT_THAT(refused.err, HasSubstr("--depth is 6 and was 5"));
  EXPECT_THAT(refused.err, HasSubstr("--engine is gates and was roth"));
  EXPECT_THAT(refused.err, Not(HasSubstr("--size")));
  EXPECT_THAT(refused.err, Not(HasSubstr(".CSG")));
  EXPECT_FALSE(folder.has("out/calice.R"));
  EXPECT_EQ(record_size(), size);
  // A quick one of another kind leaves it; one that keeps its own tiles does not.
  EXPECT_EQ(sir(with(other, {"--keep-after", "1000"})).exit_code, 0);
  EXPECT_EQ(record_size(), size);
  EXPECT_EQ(sir(with(other, {"--keep-after", "0"})).exit_code, 0);
  EXPECT_EQ(record_size(), 0u);
}

TEST_F(Resume, AChangedSceneIsNotContinued) {
  for (const char* suffix : {"CSG", "CAM", "LUZ", "SUP"})
    std::filesystem::copy_file(SIR_IMAGES "/calice." + std::string(suffix),
                               folder / ("calice." + std::string(suffix)));
  const Words words = with({"render", "calice", "--out", "out"}, kLong);
  interrupted_in_time([&] {
    return end_by(SIGKILL, with(words, {"--keep-after", "0"}), 1000).exit_code != 0 &&
           !folder.has("out/calice.R");
  });
  std::string lights = folder.read("calice.LUZ");
  folder.write("calice.LUZ", "\n" + lights);  // says the same
  const Ended again = end_by(SIGINT, with(words, {"--resume"}), record_size());
  EXPECT_THAT(again.err, HasSubstr("continued from"));
  if (!folder.has("out/calice.tiles")) leave_record(kLong);
  const std::size_t digit = lights.find_first_of("123456789");
  ASSERT_NE(digit, std::string::npos);
  lights[digit] = lights[digit] == '1' ? '2' : '1';
  folder.write("calice.LUZ", lights);
  const Ended refused = sir(with(words, {"--resume"}));
  test::expect_failure(refused, "the scene's .LUZ is another; without");
}

TEST_F(Resume, ARecordThatIsNoneIsLeftAlone) {
  folder.write("s.tiles", "my tiles");
  test::expect_failure(sir({"render", "s", "--size", "64x48", "--resume"}), "is no record");
  const Ended ended = sir({"render", "s", "--size", "64x48", "--keep-after", "0"});
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.err, HasSubstr("s.tiles: is no record of finished tiles; the render goes on"));
  EXPECT_EQ(folder.read("s.tiles"), "my tiles");
}

TEST_F(Resume, ProgressTellsWhatWasTakenOver) {
  if (!test::terminals_exist()) GTEST_SKIP() << "no terminal";
  interrupted_in_time([&] {
    leave_record(kLong);
    Start start;
    start.folder = folder.path();
    start.err_is_terminal = true;
    Program program(
        SIR_PROGRAM,
        with({"render", SIR_IMAGES "/calice", "--out", "out", "--resume", "--threads", "1"}, kLong),
        start);
    return program.wait_for(" % taken over), ");
  });
}

// What a hostile record announces is not believed, and takes no memory.
TEST_F(Resume, AHostileRecordTakesNoMemory) {
  leave_record(kLong);
  const auto path = folder / "out/calice.tiles";
  std::string settings;
  {
    const auto file = TileFile::open(path, false);
    settings = file->settings().value();
    file->start(settings);
  }
  std::string bytes = folder.read("out/calice.tiles");
  bytes += std::string(12, '\0') + std::string(4, '\xFF');
  folder.write("out/calice.tiles", bytes);
  std::filesystem::resize_file(path, std::uintmax_t{1} << 40);
  const Ended ended =
      sir(with({"render", SIR_IMAGES "/calice", "--out", "out", "--resume", "-v"}, kLong));
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.err, HasSubstr("continued from 0 finished tiles"));
  EXPECT_THAT(ended.err, HasSubstr("are dropped"));
  EXPECT_LT(ended.peak_kilobytes, 100'000);
}

// A limit on file sizes is a full disk that fills up at the record.
TEST_F(Resume, AFullDiskIsToldOnceAndTheRenderGoesOn) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 3'500;  // a plane has 3,072 bytes, the first tile more
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const Ended ended = sir({"render", "s", "--size", "64x48", "--no-png", "--keep-after", "0"});
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const std::string warning = "s.tiles: cannot be written: File too large; the render goes on";
  EXPECT_THAT(ended.err, HasSubstr(warning));
  EXPECT_EQ(ended.err.find(warning), ended.err.rfind(warning));
  EXPECT_EQ(folder.read("s.R").size(), 3'072u);
}

// The image is traced, and its place was taken meanwhile: nothing that was traced is lost.
TEST_F(Resume, WhatCannotBeWrittenIsContinuedWithRoom) {
  const Words words =
      with({"render", SIR_IMAGES "/calice", "--out", "out", "--keep-after", "0", "-v"}, kLong);
  interrupted_in_time([&] {
    Start start;
    start.folder = folder.path();
    Program program(SIR_PROGRAM, words, start);
    EXPECT_TRUE(test::eventually([&] { return folder.has("out/calice.R") || record_size() > 0; }));
    std::error_code there;
    std::filesystem::create_directory(folder / "out/calice.G", there);
    const Ended failed = program.finish();
    if (failed.exit_code == 0) return false;
    EXPECT_EQ(failed.exit_code, 1);
    EXPECT_THAT(failed.err, HasSubstr("--resume continues"));
    std::filesystem::remove(folder / "out/calice.G");
    const Ended ended = sir(with(words, {"--resume"}));
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_THAT(ended.err, HasSubstr(" taken over, 0 rendered"));
    EXPECT_EQ(record_size(), 0u);
    return true;
  });
}

TEST_F(Resume, AShortRenderLeavesNoRecordBehind) {
  EXPECT_EQ(sir({"render", "s", "--size", "64x48", "-q"}).exit_code, 0);
  EXPECT_FALSE(folder.has("s.tiles"));
}

TEST(RenderSettings, EveryOptionThatChangesPixelsIsThere) {
  const Scene scene = read_scene(SIR_IMAGES "/calice");
  const RenderOptions plain;
  const std::string before = cli::render_settings(scene, plain, false);
  EXPECT_EQ(cli::settings_difference(before, before), "");
  const auto expect_told = [&](const std::string& told, auto change) {
    RenderOptions options = plain;
    change(options);
    EXPECT_EQ(cli::settings_difference(cli::render_settings(scene, options, false), before), told);
  };
  expect_told("", [](RenderOptions& o) { o.threads = 7; });
  expect_told("", [](RenderOptions& o) { o.antialias.seed = 7; });
  expect_told("--antialias is random:16:7 and was none", [](RenderOptions& o) {
    o.antialias.mode = Antialias::random;
    o.antialias.seed = 7;
  });
  expect_told("--antialias is adaptive:9:3 and was none", [](RenderOptions& o) {
    o.antialias = {Antialias::adaptive, 9, 3};
  });
  expect_told("--region is 0,0,600,480 and was 0,0,640,480; --size is 600x480 and was 640x480",
              [](RenderOptions& o) { o.size.width = 600; });
  expect_told("--region is 1,2,3,4 and was 0,0,640,480", [](RenderOptions& o) {
    o.region = {1, 2, 3, 4};
  });
  expect_told("--precision is float and was double",
              [](RenderOptions& o) { o.precision = Precision::float_; });
  expect_told("--depth is 6 and was 5", [](RenderOptions& o) { o.trace.depth_limit = 6; });
  expect_told("--cutoff is 0.25 and was 0", [](RenderOptions& o) { o.trace.cutoff = 0.25; });
  expect_told("--past-limit is background and was zero",
              [](RenderOptions& o) { o.trace.past_limit = PastLimit::background; });
  expect_told("--engine is envelopes and was gates",
              [](RenderOptions& o) { o.trace.engine = Engine::envelopes; });
  expect_told("--formulas is textbook and was robust",
              [](RenderOptions& o) { o.trace.formulas = Formulas::textbook; });
  for (const std::string& name : EffectSet::names()) {
    RenderOptions options = plain;
    *options.trace.allowed_effects.find(name) = false;
    EXPECT_THAT(cli::settings_difference(cli::render_settings(scene, options, false), before),
                testing::StartsWith("--effects is "));
  }
  EXPECT_EQ(cli::settings_difference(cli::render_settings(scene, plain, true), before),
            "--progressive is given and was not given");
}

}  // namespace
}  // namespace sir
