#include "viewer/render_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <map>

#include "tests/eventually.h"
#include "tests/viewer_images.h"
#include "tracer/scene_file.h"

namespace sir::viewer {
namespace {

using test::eventually;

/// What is told of one job.
struct Told {
  std::atomic<int> pictures = 0;
  std::atomic<double> share = 0;
  std::atomic<bool> failed = false;
};

class RenderQueueTest : public testing::Test {
 protected:
  RenderQueueTest() {
    scene = std::make_shared<const Scene>(read_scene(SIR_IMAGES "/whitted"));
    options.threads = 1;
  }

  RenderJob job(std::size_t number) {
    Told& its = told[number];
    return {number, scene,
            [&its](const Planes&, double share) {
              its.share = share;
              ++its.pictures;
            },
            [&its](double share) { its.share = share; },
            [&its](const std::string&) { its.failed = true; }};
  }

  bool has_begun(std::size_t number) {
    return eventually([&] { return told[number].pictures > 0; });
  }
  bool has_ended(std::size_t number) {
    return eventually([&] { return told[number].share == 1; });
  }

  static constexpr ImageSize kSmall{64, 48};

  std::shared_ptr<const Scene> scene;
  RenderOptions options;
  std::map<std::size_t, Told> told;
};

TEST_F(RenderQueueTest, RendersOneAfterTheOther) {
  options.size = kSmall;
  RenderQueue queue(options);
  for (std::size_t i = 0; i < 5; ++i) queue.put(job(i));
  for (std::size_t i = 0; i < 5; ++i) EXPECT_TRUE(has_ended(i));
}

TEST_F(RenderQueueTest, ItsEndStopsWhatRunsAndBeginsNothing) {
  options.size = test::kSlowSize;
  {
    RenderQueue queue(options);
    queue.put(job(0));
    queue.put(job(1));
    ASSERT_TRUE(has_begun(0));
  }
  EXPECT_LT(told[0].share, 1);
  EXPECT_EQ(told[1].pictures, 0);
}

TEST_F(RenderQueueTest, WhatIsTakenBackMakesRoom) {
  options.size = test::kSlowSize;
  RenderQueue queue(options);
  queue.put(job(0));
  ASSERT_TRUE(has_begun(0));
  queue.put(job(1));
  queue.put(job(2));
  queue.take_back(1);
  queue.take_back(0);
  EXPECT_TRUE(has_begun(2));
  EXPECT_EQ(told[1].pictures, 0);
  EXPECT_LT(told[0].share, 1);
}

TEST_F(RenderQueueTest, ANewJobTakesThePlaceOfTheSameImages) {
  options.size = test::kSlowSize;
  RenderQueue queue(options);
  queue.put(job(0));
  ASSERT_TRUE(has_begun(0));
  RenderJob anew = job(7);
  anew.number = 0;
  queue.put(std::move(anew));
  EXPECT_TRUE(has_begun(7));
}

TEST_F(RenderQueueTest, WhatIsLookedAtGoesFirstAndTheOtherBeginsAnew) {
  options.size = test::kSlowSize;
  RenderQueue queue(options);
  queue.put(job(0));
  queue.put(job(1));
  ASSERT_TRUE(has_begun(0));
  EXPECT_EQ(told[1].pictures, 0);
  queue.look_at(1);
  ASSERT_TRUE(has_begun(1));
  told[0].pictures = 0;
  queue.look_at(0);
  EXPECT_TRUE(has_begun(0));
  told[1].pictures = 0;
  queue.take_back(0);
  EXPECT_TRUE(has_begun(1));
}

TEST_F(RenderQueueTest, AnErrorEndsTheJobAlone) {
  options.size = kSmall;
  options.region = {60, 40, 10, 10};  // beyond the image
  RenderQueue queue(options);
  for (std::size_t i = 0; i < 2; ++i) queue.put(job(i));
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_TRUE(eventually([&] { return told[i].failed.load(); }));
}

}  // namespace
}  // namespace sir::viewer
