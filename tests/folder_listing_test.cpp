// What a folder holds, for a person who chooses a file there.
#include "viewer/folder_listing.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>

#include "tests/temp_folder.h"

namespace sir::viewer {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class FolderListingTest : public testing::Test {
 protected:
  std::vector<std::string> shown(const std::vector<std::string>& suffixes) {
    std::vector<std::string> names;
    for (const FolderEntry& entry : list_folder(folder.path(), suffixes).entries)
      names.push_back(entry.shown + (entry.folder ? "/" : ""));
    return names;
  }

  test::TempFolder folder;
};

TEST_F(FolderListingTest, FoldersComeFirstAndFilesByTheirSuffix) {
  for (const char* name : {"b.CSG", "a.csg", "Zebra.CSG", "x.CAM", "none", ".hidden.CSG"})
    folder.write(name, "");
  fs::create_directory(folder / "zz");
  fs::create_directory(folder / "An.old");
  EXPECT_THAT(shown({"CSG"}), ElementsAre("An.old/", "zz/", "a.csg", "b.CSG", "Zebra.CSG"));
  EXPECT_THAT(shown({"CAM", "CSG"}),
              ElementsAre("An.old/", "zz/", "a.csg", "b.CSG", "x.CAM", "Zebra.CSG"));
  EXPECT_THAT(shown({}),
              ElementsAre("An.old/", "zz/", "a.csg", "b.CSG", "none", "x.CAM", "Zebra.CSG"));
  EXPECT_THAT(shown({"LUZ"}), ElementsAre("An.old/", "zz/"));
}

TEST_F(FolderListingTest, NamesAreOfAnyBytes) {
  folder.write("c\xC3\xA1lice.CSG", "utf-8");
  folder.write("c\xE1lice velho.CSG", "latin-1");
  folder.write("two words.CSG", "");
  folder.write(" lead and trail .CSG", "");
  folder.write("bell\a\n.CSG", "");
  EXPECT_THAT(shown({"CSG"}), ElementsAre("bell??.CSG", "cálice velho.CSG", "cálice.CSG",
                                          " lead and trail .CSG", "two words.CSG"));
  // What is shown leads to the bytes that it stands for.
  const FolderListing listing = list_folder(folder.path(), {"CSG"});
  for (const FolderEntry& entry : listing.entries)
    EXPECT_TRUE(fs::exists(named_in(listing, entry.shown))) << entry.shown;
  EXPECT_EQ(named_in(listing, "cálice velho.CSG"), folder / "c\xE1lice velho.CSG");
  EXPECT_EQ(readable("\xE1\x01"), "á?");
  EXPECT_EQ(readable("  "), "  ");
  EXPECT_EQ(readable(""), "");
}

TEST_F(FolderListingTest, WhatCannotBeReadIsSaid) {
  const FolderListing none = list_folder(folder / "none", {});
  EXPECT_THAT(none.entries, IsEmpty());
  EXPECT_THAT(none.error, HasSubstr("none"));
  folder.write("file", "");
  EXPECT_THAT(list_folder(folder / "file", {}).error, HasSubstr("file"));
  if (::geteuid() == 0) return;  // root may read anything
  fs::create_directory(folder / "shut");
  fs::permissions(folder / "shut", fs::perms::none);
  EXPECT_THAT(list_folder(folder / "shut", {}).error, HasSubstr("shut"));
  fs::permissions(folder / "shut", fs::perms::owner_all);
}

TEST_F(FolderListingTest, TheFolderIsWithoutDots) {
  fs::create_directory(folder / "in");
  EXPECT_EQ(list_folder(folder / "in" / "..", {}).folder, folder.path());
  EXPECT_EQ(list_folder(folder.path() / "", {}).folder, folder.path());
  EXPECT_EQ(list_folder(".", {}).folder, fs::current_path());
  EXPECT_EQ(list_folder("/", {}).folder, "/");
}

TEST_F(FolderListingTest, TypedNamesGoAnywhere) {
  const FolderListing listing = list_folder(folder.path(), {});
  EXPECT_EQ(named_in(listing, "x"), folder / "x");
  EXPECT_EQ(named_in(listing, "a/../x y"), folder / "x y");
  EXPECT_EQ(named_in(listing, ".."), folder.path().parent_path());
  EXPECT_EQ(named_in(listing, "/etc/x"), "/etc/x");
  ::setenv("HOME", "/home/who", 1);
  EXPECT_EQ(named_in(listing, "~/x"), "/home/who/x");
  EXPECT_EQ(named_in(listing, "~"), "/home/who");
  EXPECT_EQ(named_in(listing, "~x"), folder / "~x");
}

TEST_F(FolderListingTest, SuffixesArePutBehind) {
  EXPECT_EQ(with_one_of("/a/b", {"CSG", "model"}), "/a/b.CSG");
  EXPECT_EQ(with_one_of("/a/b.csg", {"CSG"}), "/a/b.csg");
  EXPECT_EQ(with_one_of("/a/b.MODEL", {"CSG", "model"}), "/a/b.MODEL");
  EXPECT_EQ(with_one_of("/a/v1.2", {"CSG"}), "/a/v1.2.CSG");
  EXPECT_EQ(with_one_of("/a/b", {}), "/a/b");
}

TEST_F(FolderListingTest, CommandsSayNoMoreThanTheyMust) {
  EXPECT_EQ(as_written(fs::current_path() / "a" / "b.CSG"), "a/b.CSG");
  EXPECT_EQ(as_written(fs::current_path().parent_path() / "b.CSG"),
            fs::current_path().parent_path() / "b.CSG");
  EXPECT_EQ(as_written("/none/such"), "/none/such");
}

}  // namespace
}  // namespace sir::viewer
