// Renders that are stopped and continued, in every way there is to render.
#include "tracer/tile_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include "tests/scene_builder.h"
#include "tests/temp_folder.h"
#include "tracer/error.h"
#include "tracer/render.h"
#include "tracer/sample_progressive.h"

namespace sir {
namespace {

constexpr double kAtOnce = 0, kNever = 1e9;  // seconds

class TileRecordTest : public testing::Test {
 protected:
  TileRecord::Options kept(double patience = kAtOnce) {
    TileRecord::Options options;
    options.path = path;
    options.settings = [] { return std::string("--depth 5\n"); };
    options.patience = patience;
    options.warn = [this](const std::string& reason) { warnings.push_back(reason); };
    return options;
  }

  // `ask_to_stop` after so many reports of progress; 0: never.
  static RenderResult trace(const Scene& scene, RenderOptions options, bool progressive,
                            TileKeeper* keeper, int ask_to_stop = 0) {
    options.keeper = keeper;
    std::stop_source stop;
    int reports = 0;
    const auto progress = [&](double) {
      if (++reports == ask_to_stop) stop.request_stop();
    };
    if (!progressive) return render(scene, options, progress, stop.get_token());
    return render_progressive(
        scene, options, [](const Planes&, const Stage&) {}, stop.get_token(), progress);
  }

  static RenderOptions plain() {
    RenderOptions options;
    options.size = {150, 110};
    options.threads = 2;
    return options;
  }

  test::TempFolder folder;
  const std::filesystem::path path = folder / "s.tiles";
  const Scene scene = test::random_scene(7, 9, false);
  std::vector<std::string> warnings;
};

// Stopped ever later, each time continued by what is left of it, with other numbers of threads.
TEST_F(TileRecordTest, EveryModeIsContinuedToTheSameBytesAndCounts) {
  AntialiasOptions none, adaptive, random;
  adaptive.mode = Antialias::adaptive;
  random.mode = Antialias::random;
  random.samples = 17;
  for (const AntialiasOptions& antialias : {none, adaptive, random})
    for (const bool progressive : {false, true})
      for (const Engine engine : {Engine::gates, Engine::roth, Engine::envelopes})
        for (const Precision precision :
             {Precision::float_, Precision::double_, Precision::long_double}) {
          // The samplers do not know of engines: with them, all precisions of one.
          if (antialias.mode != Antialias::none && engine != Engine::gates) continue;
          if (progressive && engine == Engine::envelopes) continue;
          RenderOptions options = plain();
          options.region = {3, 5, 101, 77};
          options.antialias = antialias;
          options.trace.engine = engine;
          options.precision = precision;
          SCOPED_TRACE(testing::Message()
                       << "antialias " << int(antialias.mode) << ", progressive " << progressive
                       << ", engine " << int(engine) << ", precision " << int(precision));
          const RenderResult whole = trace(scene, options, progressive, nullptr);
          std::size_t tiles = 0;
          int runs = 0;
          const int step = antialias.mode == Antialias::none ? 9 : 100;  // reports
          for (bool complete = false; !complete; ++runs) {
            ASSERT_LT(runs, 1000);
            TileRecord record(kept());
            const auto resumed = record.resume();
            ASSERT_EQ(resumed.tiles, tiles);
            ASSERT_EQ(resumed.dropped, 0u);
            options.threads = 1 + runs % 3;
            const RenderResult part = trace(scene, options, progressive, &record,
                                            static_cast<int>(tiles) + 7 + step * runs);
            complete = part.complete;
            tiles += record.kept();
            ASSERT_LE(record.taken(), resumed.tiles);
            if (!complete) continue;
            EXPECT_EQ(record.taken(), resumed.tiles);
            EXPECT_EQ(part.planes, whole.planes);
            EXPECT_EQ(part.counts, whole.counts);
            EXPECT_EQ(part.antialias.points, whole.antialias.points);
            EXPECT_EQ(part.antialias.divided, whole.antialias.divided);
            record.remove();
          }
          EXPECT_GT(runs, 1);
          EXPECT_FALSE(folder.has("s.tiles"));
          EXPECT_THAT(warnings, testing::IsEmpty());
        }
}

TEST_F(TileRecordTest, AllTilesFinishedLeaveNothingToTrace) {
  {
    TileRecord record(kept());
    trace(scene, plain(), false, &record);
  }
  TileRecord record(kept());
  EXPECT_EQ(record.resume().found, TileRecord::Found::tiles);
  const RenderResult again = trace(scene, plain(), false, &record);
  EXPECT_EQ(record.kept(), 0u);
  EXPECT_EQ(record.taken_share(), 1);
  EXPECT_EQ(again.planes, render(scene, plain()).planes);
}

TEST_F(TileRecordTest, AShortRenderLeavesNoTrace) {
  {
    TileRecord record(kept(kNever));
    trace(scene, plain(), false, &record);
    EXPECT_FALSE(record.flush());
    EXPECT_GT(record.kept(), 0u);
  }
  EXPECT_THAT(folder.list(), testing::IsEmpty());
}

TEST_F(TileRecordTest, OtherSettingsAreNotContinued) {
  {
    TileRecord record(kept());
    trace(scene, plain(), false, &record, 3);
  }
  const std::string before = folder.read("s.tiles");
  TileRecord::Options other = kept(kNever);
  other.settings = [] { return std::string("--depth 6\n"); };
  {
    TileRecord record(other);
    EXPECT_FALSE(record.can_resume());
    const auto resumed = record.resume();
    EXPECT_EQ(resumed.found, TileRecord::Found::other);
    EXPECT_EQ(resumed.settings, "--depth 5\n");
    // A short render of another kind does not cost what is to be continued.
    trace(scene, plain(), false, &record);
    record.remove();
  }
  EXPECT_EQ(folder.read("s.tiles"), before);
  // The same one, finished without it, has no need of it.
  TileRecord same(kept(kNever));
  EXPECT_TRUE(same.can_resume());
  trace(scene, plain(), false, &same);
  same.remove();
  EXPECT_FALSE(folder.has("s.tiles"));
}

TEST_F(TileRecordTest, TwoRendersDoNotShareARecord) {
  TileRecord first(kept());
  trace(scene, plain(), false, &first, 3);
  const std::string before = folder.read("s.tiles");
  ASSERT_THAT(before, testing::Not(testing::IsEmpty()));
  EXPECT_THAT(warnings, testing::IsEmpty());
  TileRecord second(kept());
  EXPECT_EQ(trace(scene, plain(), false, &second).planes, render(scene, plain()).planes);
  second.remove();
  EXPECT_EQ(folder.read("s.tiles"), before);
  EXPECT_THAT(warnings, testing::ElementsAre(testing::HasSubstr("in use by another render")));
  TileRecord third(kept());
  EXPECT_THROW(third.resume(), FileError);
}

TEST_F(TileRecordTest, AtItsLimitItStopsGrowing) {
  TileRecord::Options options = kept();
  options.most_bytes = 5000;
  {
    TileRecord record(options);
    trace(scene, plain(), false, &record);
    record.flush();
  }
  EXPECT_THAT(warnings, testing::ElementsAre(testing::HasSubstr("limit")));
  EXPECT_LE(std::filesystem::file_size(path), options.most_bytes);
  TileRecord record(kept());
  EXPECT_GT(record.resume().tiles, 0u);
}

// A file size limit is a full disk that nobody else notices.
TEST_F(TileRecordTest, AFullDiskEndsTheKeepingAndNotTheRender) {
  ::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  for (const rlim_t bytes : {rlim_t{20}, rlim_t{9000}}) {
    warnings.clear();
    rlimit small = before;
    small.rlim_cur = bytes;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    RenderResult result;
    {
      TileRecord record(kept());
      result = trace(scene, plain(), false, &record);
    }
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.planes, render(scene, plain()).planes);
    EXPECT_THAT(warnings, testing::ElementsAre(testing::HasSubstr("cannot be written")));
    TileRecord record(kept());
    const auto resumed = record.resume();
    EXPECT_EQ(resumed.tiles > 0, bytes > 1000);
    EXPECT_EQ(resumed.dropped, 0u);
    EXPECT_EQ(trace(scene, plain(), false, &record).planes, result.planes);
  }
}

}  // namespace
}  // namespace sir
