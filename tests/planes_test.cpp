#include "tracer/planes.h"

#include <gtest/gtest.h>

#include "tests/random_planes.h"
#include "tests/reason_of.h"
#include "tests/temp_folder.h"
#include "tracer/error.h"
#include "tracer/scene_path.h"

namespace sir {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

std::string reason_of_reading(const fs::path& base, ImageSize size) {
  return test::reason_of([&] { read_planes(base, size); });
}

class PlanesTest : public testing::Test {
 protected:
  test::TempFolder folder;
};

TEST_F(PlanesTest, ComeBackAsTheyWere) {
  for (const ImageSize size : {ImageSize{1, 1}, ImageSize{7, 5}, ImageSize{640, 480}}) {
    const Planes planes = test::random_planes(size, 3);
    write_planes(folder / "image", planes);
    EXPECT_EQ(read_planes(folder / "image", size), planes);
  }
  EXPECT_EQ(folder.list(), (Names{"image.B", "image.G", "image.R"}));
}

TEST_F(PlanesTest, AreRowsFromTheTopWithoutAHeader) {
  Planes planes(ImageSize{3, 2});
  planes.set(0, {'a', 'g', 'm'});
  planes.set(2, {'c', 'i', 'o'});
  planes.set(3, {'d', 'j', 'p'});
  EXPECT_EQ(planes.at(2), (Rgb8{'c', 'i', 'o'}));
  write_planes(folder / "p", planes);
  const std::string nul(1, '\0');
  EXPECT_EQ(folder.read("p.R"), "a" + nul + "cd" + nul + nul);
  EXPECT_EQ(folder.read("p.G"), "g" + nul + "ij" + nul + nul);
  EXPECT_EQ(folder.read("p.B"), "m" + nul + "op" + nul + nul);
}

TEST_F(PlanesTest, TheSuffixMayBeInLowerCase) {
  const Planes planes = test::random_planes({4, 4}, 5);
  write_planes(folder / "image", planes);
  for (const char* suffix : {"r", "g", "b"}) {
    const std::string upper{static_cast<char>(suffix[0] - 'a' + 'A')};
    fs::rename(folder / ("image." + upper), folder / (std::string("image.") + suffix));
  }
  EXPECT_EQ(read_planes(folder / "image", {4, 4}), planes);
  // Upper case goes first where there are both.
  folder.write("image.R", std::string(16, 'x'));
  EXPECT_EQ(read_planes(folder / "image", {4, 4}).channel[0][0], 'x');
}

TEST_F(PlanesTest, ADotInTheNameIsKept) {
  EXPECT_EQ(with_suffix("a/v1.5", "R"), fs::path("a/v1.5.R"));
  EXPECT_EQ(plane_path("a/v1.5", 2), fs::path("a/v1.5.B"));
  write_planes(folder / "v1.5", test::random_planes({2, 2}, 1));
  EXPECT_EQ(read_planes(folder / "v1.5", {2, 2}), test::random_planes({2, 2}, 1));
}

TEST_F(PlanesTest, AnotherLengthIsRefusedWithTheWayOut) {
  write_planes(folder / "image", test::random_planes({4, 4}, 5));
  const std::string g = (folder / "image.G").string();
  for (const std::size_t length : {15u, 17u, 0u}) {
    folder.write("image.G", std::string(length, 'x'));
    EXPECT_EQ(reason_of_reading(folder / "image", {4, 4}),
              g + ": holds " + std::to_string(length) +
                  " bytes where an image of 4x4 has 16; another size is given by --size WxH");
  }
}

TEST_F(PlanesTest, AMissingPlaneIsNamedWithThePlacesLookedAt) {
  write_planes(folder / "image", test::random_planes({4, 4}, 5));
  for (const char* suffix : {"B", "G", "R"}) {
    fs::remove(with_suffix(folder / "image", suffix));
    const std::string upper = with_suffix(folder / "image", suffix).string();
    std::string lower = upper;
    lower.back() = static_cast<char>(lower.back() - 'A' + 'a');
    EXPECT_EQ(reason_of_reading(folder / "image", {4, 4}),
              upper + ": is missing (looked for " + upper + " and " + lower + ")");
  }
}

TEST_F(PlanesTest, AFolderIsNoPlane) {
  write_planes(folder / "image", test::random_planes({4, 4}, 5));
  fs::remove(folder / "image.G");
  fs::create_directory(folder / "image.G");
  EXPECT_EQ(reason_of_reading(folder / "image", {4, 4}).find((folder / "image.G").string() + ": "),
            0u);
}

TEST_F(PlanesTest, AnImageThatCannotBeWrittenWholeLeavesTheOldOne) {
  const Planes old = test::random_planes({4, 4}, 5);
  write_planes(folder / "image", old);
  const auto blue = folder.read("image.B");
  fs::remove(folder / "image.B");
  fs::create_directory(folder / "image.B");
  EXPECT_THROW(write_planes(folder / "image", test::random_planes({4, 4}, 6)), FileError);
  fs::remove(folder / "image.B");
  folder.write("image.B", blue);
  EXPECT_EQ(read_planes(folder / "image", {4, 4}), old);
  EXPECT_EQ(folder.list(), (Names{"image.B", "image.G", "image.R"}));
}

}  // namespace
}  // namespace sir
