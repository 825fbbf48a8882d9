#include "viewer/source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/random_planes.h"
#include "tests/reason_of.h"
#include "tests/temp_folder.h"
#include "tests/viewer_images.h"
#include "tracer/scene_path.h"
#include "viewer/image_name.h"
#include "viewer/png_file.h"

namespace sir::viewer {
namespace {

namespace fs = std::filesystem;
using test::random_planes;
using test::reason_of;
using test::set_age;
using testing::HasSubstr;

constexpr ImageSize kSize{16, 12};

TEST(ImageName, TellsPngFilesFromBaseNames) {
  for (const char* name : {"a.png", "a.PNG", "x/b.c.PnG"}) EXPECT_TRUE(is_png(name)) << name;
  for (const char* name : {"a", "a.pngx", "png", "a.R", ".png"}) EXPECT_FALSE(is_png(name)) << name;
  EXPECT_EQ(base_name("x/a.b.png"), "x/a.b");
  EXPECT_EQ(base_name("x/a.b"), "x/a.b");
}

class SourceTest : public testing::Test {
 protected:
  // Scene and planes of given ages in seconds.
  void write_both(int scene_age, int planes_age) {
    test::write_small_scene(folder, "s");
    write_planes(folder / "s", planes);
    for (const char* suffix : {"CSG", "CAM", "LUZ", "SUP"})
      set_age(with_suffix(folder / "s", suffix), scene_age);
    for (const char* suffix : {"R", "G", "B"})
      set_age(with_suffix(folder / "s", suffix), planes_age);
  }

  test::TempFolder folder;
  const Planes planes = random_planes(kSize, 1);
};

TEST_F(SourceTest, TheNameOfAFileOfTheImageIsItsBase) {
  test::write_small_scene(folder, "s");
  folder.write("s.csg", "");
  EXPECT_EQ(Source(folder / "s.CSG").input(), folder / "s");
  EXPECT_EQ(Source(folder / "s.csg").base(), folder / "s");
  EXPECT_EQ(Source(folder / "t.CSG").input(), folder / "t.CSG") << "there is no such file";
  EXPECT_EQ(Source(folder / "s.png").base(), folder / "s");
}

TEST_F(SourceTest, NamesItsFilesInEitherCaseAndThoseThatAreMissing) {
  folder.write("s.CSG", "");
  folder.write("s.cam", "");
  folder.write("s.g", "");
  const std::vector<fs::path> expected{folder / "s.CSG", folder / "s.cam", folder / "s.LUZ",
                                       folder / "s.SUP", folder / "s.R",   folder / "s.g",
                                       folder / "s.B"};
  EXPECT_EQ(Source(folder / "s").files(), expected);
  EXPECT_EQ(Source(folder / "s.png").files(), std::vector<fs::path>{folder / "s.png"});
}

TEST_F(SourceTest, PlanesAreCurrentWhereNoneIsOlderThanAFileOfTheScene) {
  const Source source(folder / "s");
  EXPECT_FALSE(source.planes_are_current()) << "there are none";
  write_both(200, 100);
  EXPECT_TRUE(source.planes_are_current());
  write_both(100, 100);
  set_age(folder / "s.G", 101);
  EXPECT_FALSE(source.planes_are_current());
  EXPECT_TRUE(source.is_to_be_rendered());
  write_both(200, 100);
  set_age(folder / "s.CAM", 50);
  EXPECT_FALSE(source.planes_are_current());
  for (const char* file : {"s.CSG", "s.CAM", "s.LUZ", "s.SUP"}) fs::remove(folder / file);
  EXPECT_TRUE(source.planes_are_current()) << "there is no scene";
  EXPECT_FALSE(source.is_to_be_rendered());
  fs::remove(folder / "s.R");
  EXPECT_FALSE(source.planes_are_current());
  EXPECT_FALSE(source.is_to_be_rendered());
}

TEST_F(SourceTest, ReadsAPng) {
  write_rgb_png(folder / "p.png", planes);
  const auto contents = read_source(Source(folder / "p.png"), {});
  ASSERT_TRUE(contents.picture);
  EXPECT_FALSE(contents.scene);
  EXPECT_EQ(contents.picture->planes, planes);
  EXPECT_EQ(contents.picture->input, folder / "p.png");
  EXPECT_EQ(contents.picture->base, folder / "p");
  EXPECT_EQ(contents.picture->share, 1);
  EXPECT_FALSE(contents.picture->scene);
}

TEST_F(SourceTest, ReadsCurrentPlanesWithTheSceneBehindThem) {
  write_both(200, 100);
  const auto contents = read_source(Source(folder / "s"), kSize);
  ASSERT_TRUE(contents.picture);
  EXPECT_EQ(contents.picture->planes, planes);
  ASSERT_TRUE(contents.picture->scene);
  EXPECT_EQ(contents.picture->scene->tree.nodes.size(), 3u);
}

TEST_F(SourceTest, ADamagedSceneLeavesCurrentPlanesWithoutOne) {
  write_both(200, 100);
  folder.write("s.SUP", "nonsense");
  set_age(folder / "s.SUP", 200);
  const auto contents = read_source(Source(folder / "s"), kSize);
  ASSERT_TRUE(contents.picture);
  EXPECT_FALSE(contents.picture->scene);
}

TEST_F(SourceTest, ASceneWithoutPlanesOrWithOlderOnesIsToBeRendered) {
  write_both(100, 200);
  auto contents = read_source(Source(folder / "s"), kSize);
  EXPECT_FALSE(contents.picture);
  ASSERT_TRUE(contents.scene);
  fs::remove(folder / "s.B");
  EXPECT_TRUE(read_source(Source(folder / "s"), kSize).scene);
}

TEST_F(SourceTest, SaysWhatIsWrong) {
  const auto reason = [&](const char* name, ImageSize size) {
    return reason_of([&] { (void)read_source(Source(folder / name), size); });
  };
  EXPECT_THAT(reason("none", kSize), HasSubstr("neither a scene (.CSG .CAM .LUZ .SUP) nor planes"));
  EXPECT_THAT(reason("none.png", kSize), HasSubstr("none.png"));
  write_both(200, 100);
  EXPECT_THAT(reason("s", {640, 480}), HasSubstr("another size is given by --size WxH"));
  fs::remove(folder / "s.CSG");
  fs::remove(folder / "s.R");
  EXPECT_THAT(reason("s", kSize), HasSubstr("s.CSG: is missing"));
  folder.write("t.G", "");
  EXPECT_THAT(reason("t", kSize), HasSubstr("t.R: is missing"));
  fs::create_directory(folder / "folder.png");
  EXPECT_THAT(reason("folder.png", kSize), HasSubstr("is no regular file"));
  ASSERT_EQ(::mkfifo((folder / "pipe.CSG").c_str(), 0600), 0);
  EXPECT_THAT(reason("pipe", kSize), HasSubstr("pipe.CSG: is no regular file"));
}

}  // namespace
}  // namespace sir::viewer
