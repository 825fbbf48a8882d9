// What the workshop reads, renders and makes.
#include "viewer/workshop.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <semaphore>
#include <vector>

#include "tests/random_planes.h"
#include "tests/workshop_fixture.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"
#include "viewer/latest.h"

namespace sir::viewer {
namespace {

using test::eventually;
using test::random_planes;
using test::WorkshopTest;
using testing::HasSubstr;

/// Stops whoever wakes the window until the window has looked.
class Turns {
 public:
  void wake() {
    const std::scoped_lock one_at_a_time(mutex_);
    if (free_) return;
    waiting_ = true;
    looked_.acquire();
  }

  template <typename Look>
  void look(Look look_at) {
    if (!waiting_.exchange(false)) return;
    look_at();
    looked_.release();
  }

  void let_go() {
    free_ = true;
    if (waiting_.exchange(false)) looked_.release();
  }

 private:
  std::mutex mutex_;
  std::atomic<bool> waiting_ = false, free_ = false;
  std::binary_semaphore looked_{0};
};

Planes rendered(const std::filesystem::path& base, ImageSize size) {
  RenderOptions options;
  options.size = size;
  return render(read_scene(base), options).planes;
}

TEST_F(WorkshopTest, OpensAPng) {
  const Planes planes = random_planes({5, 7}, 1);
  write_rgb_png(folder / "p.png", planes);
  const std::size_t number = open("p.png");
  const auto state = settled(number);
  ASSERT_TRUE(state.picture);
  EXPECT_EQ(state.picture->planes, planes);
  EXPECT_EQ(state.picture->base, folder / "p");
  EXPECT_EQ(state.message, "");
  EXPECT_FALSE(state.failed);
  EXPECT_EQ(state.version, 1u);
}

TEST_F(WorkshopTest, OpensPlanes) {
  const Planes planes = random_planes(kSize, 1);
  write_planes(folder / "s", planes);
  const auto state = settled(open("s.R"));
  ASSERT_TRUE(state.picture);
  EXPECT_EQ(state.picture->planes, planes);
  EXPECT_EQ(state.picture->input, folder / "s");
}

TEST_F(WorkshopTest, RendersASceneWithoutPlanes) {
  test::write_small_scene(folder, "s");
  const auto state = settled(open("s"));
  ASSERT_TRUE(state.picture);
  EXPECT_EQ(state.picture->planes, rendered(folder / "s", kSize));
  EXPECT_EQ(state.picture->share, 1);
  ASSERT_TRUE(state.picture->scene);
  EXPECT_EQ(state.picture->scene->tree.nodes.size(), 3u);
  EXPECT_FALSE(folder.has("s.R")) << "nothing is written";
}

TEST_F(WorkshopTest, RendersASceneWhosePlanesAreOlderAndReadsCurrentOnes) {
  test::write_small_scene(folder, "s");
  const Planes planes = random_planes(kSize, 1);
  write_planes(folder / "s", planes);
  for (const char* file : {"s.R", "s.G", "s.B"}) test::set_age(folder / file, 100);
  const auto fresh = settled(open("s"));
  ASSERT_TRUE(fresh.picture);
  EXPECT_EQ(fresh.picture->planes, rendered(folder / "s", kSize));
  for (const char* file : {"s.CSG", "s.CAM", "s.LUZ", "s.SUP"}) test::set_age(folder / file, 200);
  EXPECT_TRUE(comes_to_show(0, planes));
  EXPECT_TRUE(state(0).picture->scene);
}

TEST_F(WorkshopTest, PicturesComeCoarseToFine) {
  Turns turns;
  options.size = {160, 120};
  options.wake = [&] { turns.wake(); };
  test::write_small_scene(folder, "s");
  const std::size_t number = open("s");
  std::vector<std::shared_ptr<const Picture>> pictures;
  std::vector<std::string> messages;
  const bool ended = eventually([&] {
    bool busy = true;
    turns.look([&] {
      const auto now = state(number);
      busy = now.busy;
      if (now.picture && (pictures.empty() || pictures.back() != now.picture))
        pictures.push_back(now.picture);
      EXPECT_EQ(now.version, pictures.size());
      messages.push_back(now.message);
    });
    return !busy;
  });
  turns.let_go();
  close();
  ASSERT_TRUE(ended);
  ASSERT_GE(pictures.size(), 3u);
  EXPECT_LT(pictures.front()->share, 1. / 200);
  for (std::size_t i = 1; i < pictures.size(); ++i)
    EXPECT_GT(pictures[i]->share, pictures[i - 1]->share);
  EXPECT_EQ(pictures.back()->share, 1);
  EXPECT_EQ(pictures.back()->planes, rendered(folder / "s", options.size));
  EXPECT_THAT(messages, testing::Contains("rendering 0 %"));
  EXPECT_THAT(messages, testing::Contains(testing::MatchesRegex("rendering [1-9].* %")));
  EXPECT_EQ(messages.back(), "");
}

TEST_F(WorkshopTest, SaysWhatIsWrong) {
  EXPECT_THAT(settled(open("none")).message, HasSubstr("is no image"));
  EXPECT_TRUE(state(0).failed);
  EXPECT_FALSE(state(0).picture);
  EXPECT_EQ(workshop().shown(0, Method::hsv_median).rendition, nullptr);

  write_planes(folder / "s", random_planes({3, 3}, 1));
  EXPECT_THAT(settled(open("s")).message, HasSubstr("--size WxH"));

  test::write_small_scene(folder, "bad");
  folder.write("bad.CAM", "4 3\n.5 .5 .5\n-1 -1 minus\n4\n0 1 0\n");
  EXPECT_THAT(settled(open("bad")).message, HasSubstr("bad.CAM:3"));
}

TEST_F(WorkshopTest, TakesManyInputsAndTheSameOneTwice) {
  constexpr std::size_t kMany = 60;
  for (std::size_t i = 0; i < kMany; ++i) {
    write_rgb_png(folder / (std::to_string(i) + ".png"),
                  random_planes(kSize, static_cast<unsigned>(i)));
    EXPECT_EQ(open(std::to_string(i) + ".png"), i);
  }
  EXPECT_EQ(open("7.png"), kMany);
  test::write_small_scene(folder, "s");
  for (int i = 0; i < 3; ++i) open("s");
  EXPECT_EQ(workshop().count(), kMany + 4);
  for (std::size_t i = 0; i < kMany; ++i) {
    const auto state = settled(i);
    ASSERT_TRUE(state.picture) << state.message;
    EXPECT_EQ(state.picture->planes, random_planes(kSize, static_cast<unsigned>(i)));
  }
  EXPECT_EQ(settled(kMany).picture->planes, settled(7).picture->planes);
  for (std::size_t i = kMany + 1; i < kMany + 4; ++i)
    EXPECT_EQ(settled(i).picture->planes, rendered(folder / "s", kSize));
}

TEST_F(WorkshopTest, AnImageThatIsLookedAtIsRenderedFirst) {
  options.size = test::kSlowSize;
  test::write_slow_scene(folder, "s");
  const std::size_t first = open("s"), second = open("s");
  ASSERT_TRUE(eventually([&] { return state(first).picture != nullptr; }));
  EXPECT_FALSE(state(second).picture);
  workshop().end_drawing(second);
  EXPECT_TRUE(eventually([&] { return state(second).picture != nullptr; }));
  EXPECT_TRUE(state(first).busy) << "it was put off";
  EXPECT_TRUE(state(first).picture) << "what there was of it stays";
}

// A render that goes on to its end tells of each percent.
TEST_F(WorkshopTest, ItsEndDoesNotWaitForARender) {
  std::atomic<int> wakes = 0;
  options.size = test::kSlowSize;
  options.wake = [&] { ++wakes; };
  test::write_slow_scene(folder, "s");
  const std::size_t number = open("s");
  ASSERT_TRUE(eventually([&] { return state(number).picture != nullptr; }));
  (void)workshop().shown(number, Method::best);
  close();
  EXPECT_LT(wakes, 100);
}

TEST_F(WorkshopTest, RenditionsAreThoseOfMakeRendition) {
  write_rgb_png(folder / "p.png", random_planes({70, 50}, 3));
  options.rendition.map.reserved.set(9);
  const std::size_t number = open("p.png");
  const auto picture = settled(number).picture;
  for (const Method method : {Method::rgb_frequency, Method::rgb_median, Method::hsv_frequency,
                              Method::hsv_median, Method::best}) {
    const auto made = rendition(number, method);
    ASSERT_TRUE(made);
    const Rendition expected = make_rendition(*picture, method, options.rendition);
    EXPECT_EQ(made->lut, expected.lut) << name(method);
    EXPECT_EQ(made->indices, expected.indices);
    EXPECT_EQ(made->seen, expected.seen);
    const auto shown = workshop().shown(number, method);
    EXPECT_TRUE(shown.current);
    EXPECT_EQ(shown.picture, picture);
  }
  EXPECT_EQ(workshop().shown(number, Method::true_colour).rendition, nullptr);
}

TEST_F(WorkshopTest, AMissingOrBadLutFileIsSaid) {
  write_rgb_png(folder / "p.png", random_planes(kSize, 3));
  const std::size_t number = open("p.png");
  (void)settled(number);
  EXPECT_TRUE(comes_to_say(number, Method::lut_file, "p.LUT: is missing"));
  const auto shown = workshop().shown(number, Method::lut_file);
  EXPECT_FALSE(shown.current);
  EXPECT_EQ(shown.rendition, nullptr);
  EXPECT_FALSE(state(number).failed) << "the picture is good";
  folder.write("p.LUT", "1 2 3 4\n");
  EXPECT_TRUE(comes_to_say(number, Method::lut_file, "p.LUT:1"));
}

TEST_F(WorkshopTest, FurtherResultsFollowPictureAndRendition) {
  write_rgb_png(folder / "p.png", test::plain_planes(kSize, {255, 255, 255}));
  const std::size_t number = open("p.png");
  Latest<Rgb8> corner;
  const auto comes_to_be = [&](Rgb8 colour) {
    return eventually([&] {
      const auto [picture, made, current] = workshop().shown(number, Method::best);
      if (!current) return false;
      const Ingredients of{picture, made};
      const auto result =
          corner.get(workshop().worker(), of, [picture, made](const std::stop_token&) {
            EXPECT_EQ(picture->planes.at(0), made->seen.at(0)) << "both are on the lattice";
            return std::make_shared<const Rgb8>(made->seen.at(0));
          });
      return corner.is_current(of) && *result == colour;
    });
  };
  EXPECT_TRUE(comes_to_be({255, 255, 255})) << corner.error();
  write_rgb_png(folder / "p.png", test::plain_planes(kSize, {0, 0, 0}));
  EXPECT_TRUE(comes_to_be({0, 0, 0})) << corner.error();
}

}  // namespace
}  // namespace sir::viewer
