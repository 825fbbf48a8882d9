// What the workshop does when files change.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "quant/choose.h"
#include "tests/random_planes.h"
#include "tests/workshop_fixture.h"
#include "tracer/atomic_file.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"

namespace sir::viewer {
namespace {

namespace fs = std::filesystem;
using test::eventually;
using test::random_planes;
using test::WorkshopTest;
using testing::HasSubstr;

class WorkshopReloadTest : public WorkshopTest {
 protected:
  // The bytes of a PNG, to be written by other ways than the library's.
  std::string png_bytes(const Planes& planes) const {
    write_rgb_png(folder / "elsewhere.png", planes);
    return folder.read("elsewhere.png");
  }

  Planes rendered() const {
    RenderOptions render_options;
    render_options.size = kSize;
    return render(read_scene(folder / "s"), render_options).planes;
  }
};

TEST_F(WorkshopReloadTest, EveryChangeOfAPngIsShown) {
  write_rgb_png(folder / "p.png", random_planes(kSize, 0));
  const std::size_t number = open("p.png");
  ASSERT_TRUE(comes_to_show(number, random_planes(kSize, 0)));
  std::uint64_t version = state(number).version;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Planes planes = random_planes({20 + static_cast<int>(seed), 10}, seed);
    if (seed % 2 == 0) write_rgb_png(folder / "p.png", planes);  // a rename
    else folder.write("p.png", png_bytes(planes));               // in place
    EXPECT_TRUE(comes_to_show(number, planes)) << seed;
    EXPECT_GT(state(number).version, version);
    version = state(number).version;
  }
}

// Files of one length, written within a tick of the file system's clock.
TEST_F(WorkshopReloadTest, EveryChangeOfPlanesIsShown) {
  write_planes(folder / "s", random_planes(kSize, 0));
  const std::size_t number = open("s");
  ASSERT_TRUE(comes_to_show(number, random_planes(kSize, 0)));
  const auto time = fs::last_write_time(folder / "s.R");
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Planes planes = random_planes(kSize, seed);
    for (int c = 0; c < 3; ++c) {
      const auto& bytes = planes.channel[static_cast<std::size_t>(c)];
      const fs::path path = plane_path(folder / "s", c);
      folder.write(path.filename().string(), std::string(bytes.begin(), bytes.end()));
      fs::last_write_time(path, time);
    }
    EXPECT_TRUE(comes_to_show(number, planes)) << seed;
  }
  write_planes(folder / "s", random_planes(kSize, 9));
  EXPECT_TRUE(comes_to_show(number, random_planes(kSize, 9)));
}

TEST_F(WorkshopReloadTest, PlanesOfTwoImagesAreNotMixed) {
  options.watch_every = std::chrono::milliseconds(500);  // far longer than three renames take
  const auto plain = [](unsigned shade) {
    const auto byte = static_cast<std::uint8_t>(shade);
    return test::plain_planes(kSize, {byte, byte, byte});
  };
  write_planes(folder / "s", plain(0));
  const std::size_t number = open("s");
  for (unsigned shade = 1; shade <= 3; ++shade) {
    write_planes(folder / "s", plain(shade));
    EXPECT_TRUE(eventually([&] {
      const auto now = state(number);
      if (!now.picture) return false;
      const Rgb8 seen = now.picture->planes.at(0);
      EXPECT_EQ(seen, (Rgb8{seen.r, seen.r, seen.r}));
      return seen.r == shade;
    }));
  }
}

TEST_F(WorkshopReloadTest, WhatVanishesStaysInSightAndComesBack) {
  const Planes planes = random_planes(kSize, 1);
  write_rgb_png(folder / "p.png", planes);
  const std::size_t number = open("p.png");
  ASSERT_TRUE(comes_to_show(number, planes));
  for (int i = 0; i < 3; ++i) {
    fs::rename(folder / "p.png", folder / "away.png");
    ASSERT_TRUE(comes_to_fail(number));
    EXPECT_THAT(state(number).message, HasSubstr("p.png"));
    EXPECT_EQ(state(number).picture->planes, planes);
    fs::rename(folder / "away.png", folder / "p.png");
    EXPECT_TRUE(comes_to_show(number, planes));
    EXPECT_EQ(state(number).message, "");
  }
}

TEST_F(WorkshopReloadTest, AnInputMayAppearLater) {
  const std::size_t number = open("s");
  ASSERT_TRUE(comes_to_fail(number));
  test::write_small_scene(folder, "s");
  EXPECT_TRUE(comes_to_show(number, rendered()));
}

TEST_F(WorkshopReloadTest, AHalfWrittenPngLeavesTheLastGoodPicture) {
  const Planes before = random_planes(kSize, 1), after = random_planes(kSize, 2);
  write_rgb_png(folder / "p.png", before);
  const std::size_t number = open("p.png");
  ASSERT_TRUE(comes_to_show(number, before));
  const std::string bytes = png_bytes(after);
  folder.write("p.png", bytes.substr(0, bytes.size() / 2));
  ASSERT_TRUE(comes_to_fail(number));
  EXPECT_EQ(state(number).picture->planes, before);
  std::ofstream(folder / "p.png", std::ios::app | std::ios::binary)
      << bytes.substr(bytes.size() / 2);
  EXPECT_TRUE(comes_to_show(number, after));
}

TEST_F(WorkshopReloadTest, PlanesOfAnotherSizeAreNotShown) {
  const Planes planes = random_planes(kSize, 1);
  write_planes(folder / "s", planes);
  const std::size_t number = open("s");
  ASSERT_TRUE(comes_to_show(number, planes));
  write_planes(folder / "s", random_planes({9, 9}, 1));
  ASSERT_TRUE(comes_to_fail(number));
  EXPECT_THAT(state(number).message, HasSubstr("holds 81 bytes"));
  EXPECT_EQ(state(number).picture->planes, planes);
}

TEST_F(WorkshopReloadTest, EveryChangeOfASceneIsRendered) {
  test::write_small_scene(folder, "s");
  const std::size_t number = open("s");
  ASSERT_TRUE(comes_to_show(number, rendered()));
  for (const double red : {0.1, 0.9, 0.2, 0.8, 0.3}) {
    test::write_small_scene(folder, "s", red);
    EXPECT_TRUE(comes_to_show(number, rendered())) << red;
  }
  const auto last = state(number).picture;
  folder.write("s.LUZ", "0 0 .2\n.1\n1\n5 6 7 nothing\n");
  ASSERT_TRUE(comes_to_fail(number));
  EXPECT_THAT(state(number).message, HasSubstr("s.LUZ:4"));
  EXPECT_EQ(state(number).picture, last);
  folder.write("s.LUZ", "0 0 .2\n.1\n1\n7 6 5 1\n");
  EXPECT_TRUE(comes_to_show(number, rendered()));
}

TEST_F(WorkshopReloadTest, PlanesThatARenderWritesReplaceThePicture) {
  test::write_small_scene(folder, "s");
  const std::size_t number = open("s");
  ASSERT_TRUE(comes_to_show(number, rendered()));
  const Planes planes = random_planes(kSize, 4);
  write_planes(folder / "s", planes);
  EXPECT_TRUE(comes_to_show(number, planes));
}

TEST_F(WorkshopReloadTest, AnEditedSceneIsRenderedAnewAtOnce) {
  options.size = test::kSlowSize;
  test::write_slow_scene(folder, "s");
  const std::size_t number = open("s");
  ASSERT_TRUE(eventually([&] { return state(number).picture != nullptr; }));
  const auto first = state(number).picture;
  ASSERT_LT(first->share, 1);
  for (const char* light : {"1 0 0", "0 1 0", "0 0 1"}) {
    const auto before = state(number).picture;
    folder.write("s.LUZ", std::string("0 0 0\n.2\n1\n-4 9 4 ") + light + "\n");
    ASSERT_TRUE(eventually([&] { return state(number).picture->scene != before->scene; }));
    EXPECT_LT(state(number).picture->share, 1);
    EXPECT_TRUE(state(number).busy);
    EXPECT_EQ(lighting_text(state(number).picture->scene->lighting),
              lighting_text(read_scene(folder / "s").lighting));
  }
}

TEST_F(WorkshopReloadTest, ReloadReadsAgainWhatDidNotChange) {
  write_rgb_png(folder / "p.png", random_planes(kSize, 1));
  const std::size_t number = open("p.png");
  const auto before = settled(number);
  workshop().reload(number);
  ASSERT_TRUE(eventually([&] { return state(number).version > before.version; }));
  const auto after = settled(number);
  EXPECT_EQ(after.version, before.version + 1);
  EXPECT_NE(after.picture, before.picture);
  EXPECT_EQ(after.picture->planes, before.picture->planes);
}

TEST_F(WorkshopReloadTest, ALutFileThatChangesIsShownEachTimeAndNothingElseIsMade) {
  const Planes planes = random_planes(kSize, 1);
  write_rgb_png(folder / "p.png", planes);
  quant::Lut lut = quant::choose_lut(planes);
  write_lut(folder / "p.LUT", lut);
  const std::size_t number = open("p.png");
  ASSERT_TRUE(comes_to_show(number, planes));
  const auto median = rendition(number, Method::hsv_median);
  const auto picture = state(number).picture;
  const auto shows = [&](const quant::Lut& expected) {
    return eventually([&] {
      const auto shown = workshop().shown(number, Method::lut_file);
      return shown.current && shown.rendition->lut == expected;
    });
  };
  EXPECT_TRUE(shows(lut));
  for (std::uint8_t code = 10; code < 15; ++code) {
    lut.entry[0] = {code, code, code};
    if (code % 2 == 0) write_lut(folder / "p.LUT", lut);
    else folder.write("p.LUT", lut_text(lut));
    EXPECT_TRUE(shows(lut)) << int{code};
  }
  fs::remove(folder / "p.LUT");
  EXPECT_TRUE(comes_to_say(number, Method::lut_file, "is missing"));
  EXPECT_EQ(workshop().shown(number, Method::lut_file).rendition->lut, lut) << "the last good one";
  folder.write("p.lut", lut_text(lut));
  EXPECT_TRUE(shows(lut));
  EXPECT_EQ(workshop().rendition_error(number, Method::lut_file), "");

  EXPECT_EQ(rendition(number, Method::hsv_median), median);
  EXPECT_EQ(state(number).picture, picture);
}

}  // namespace
}  // namespace sir::viewer
