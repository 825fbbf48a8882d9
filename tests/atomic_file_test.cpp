#include "tracer/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>

#include "tests/reason_of.h"
#include "tests/temp_folder.h"
#include "tracer/error.h"

namespace sir {
namespace {

using test::reason_of;
namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class AtomicFileTest : public testing::Test {
 protected:
  test::TempFolder folder;
};

TEST_F(AtomicFileTest, ShowsTheNewContentOnlyAfterCommit) {
  const auto path = folder.write("a", "old");
  {
    AtomicFile file(path);
    file.write("new ");
    file.write(std::as_bytes(std::span("content", 7)));
    EXPECT_EQ(folder.read("a"), "old");
    file.commit();
  }
  EXPECT_EQ(folder.read("a"), "new content");
  EXPECT_EQ(folder.list(), Names{"a"});
}

TEST_F(AtomicFileTest, WithoutCommitNothingHappened) {
  const auto path = folder.write("a", "old");
  { AtomicFile(path).write("new"); }
  { AtomicFile(folder / "b").write("new"); }
  EXPECT_EQ(folder.read("a"), "old");
  EXPECT_EQ(folder.list(), Names{"a"});
}

TEST_F(AtomicFileTest, WritesAWholeFileInOneStep) {
  write_file_atomically(folder / "a", "");
  EXPECT_EQ(folder.read("a"), "");
  const std::string large(3'000'000, 'x');
  write_file_atomically(folder / "a", large);
  EXPECT_EQ(folder.read("a"), large);
  EXPECT_EQ(folder.list(), Names{"a"});
}

TEST_F(AtomicFileTest, TwoWritersOfOneFileDoNotMix) {
  AtomicFile first(folder / "a"), second(folder / "a");
  first.write("first");
  second.write("second");
  first.commit();
  second.commit();
  EXPECT_EQ(folder.read("a"), "second");
  EXPECT_EQ(folder.list(), Names{"a"});
}

TEST_F(AtomicFileTest, RemoveTemporariesLeavesNone) {
  write_file_atomically(folder / "done", "x");
  {
    AtomicFile a(folder / "a"), b(folder / "b");
    a.write("half");
    remove_temporaries();
    EXPECT_EQ(folder.list(), Names{"done"});
  }
  // More at a time than are remembered are no harm.
  std::vector<std::unique_ptr<AtomicFile>> many;
  for (int i = 0; i < 40; ++i)
    many.push_back(std::make_unique<AtomicFile>(folder / std::to_string(i)));
  for (const auto& file : many) file->commit();
  EXPECT_EQ(folder.list().size(), 41u);
  remove_temporaries();
  EXPECT_EQ(folder.list().size(), 41u);
}

TEST_F(AtomicFileTest, ReportsAFullDisk) {
  EXPECT_EQ(reason_of([] { write_file_atomically("/dev/full", "x"); }),
            "/dev/full: cannot be written: No space left on device");
}

TEST_F(AtomicFileTest, DevicesArePassedThroughNotReplaced) {
  write_file_atomically("/dev/null", "x");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(AtomicFileTest, PipesArePassedThroughNotReplaced) {
  const auto path = folder / "pipe";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
  write_file_atomically(path, "through");
  std::array<char, 16> got{};
  EXPECT_EQ(::read(reader, got.data(), got.size()), 7);
  ::close(reader);
  EXPECT_TRUE(fs::is_fifo(path));
  EXPECT_EQ(folder.list(), Names{"pipe"});
}

TEST_F(AtomicFileTest, FollowsSymbolicLinks) {
  fs::create_directory(folder / "sub");
  folder.write("sub/target", "old");
  fs::create_symlink("sub/target", folder / "inner");
  fs::create_symlink("inner", folder / "outer");
  write_file_atomically(folder / "outer", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "outer"));
  EXPECT_TRUE(fs::is_symlink(folder / "inner"));
  EXPECT_EQ(folder.read("sub/target"), "new");
}

TEST_F(AtomicFileTest, FollowsASymbolicLinkToAFileYetToBe) {
  fs::create_symlink("target", folder / "link");
  write_file_atomically(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(folder.read("target"), "new");
}

TEST_F(AtomicFileTest, ALinkToItselfIsAnError) {
  fs::create_symlink("loop", folder / "loop");
  EXPECT_NE(reason_of([&] { write_file_atomically(folder / "loop", "x"); }), "no error");
  EXPECT_EQ(folder.list(), Names{"loop"});
}

TEST_F(AtomicFileTest, KeepsThePermissionsOfAReplacedFile) {
  const auto path = folder.write("a", "old");
  for (const mode_t mode : {0600, 0755, 0664}) {
    ASSERT_EQ(::chmod(path.c_str(), mode), 0);
    write_file_atomically(path, "new");
    struct stat now {};
    ASSERT_EQ(::stat(path.c_str(), &now), 0);
    EXPECT_EQ(now.st_mode & 07777, mode);
  }
}

TEST_F(AtomicFileTest, NewFilesHaveThePermissionsOfAnyNewFile) {
  const mode_t before = ::umask(027);
  write_file_atomically(folder / "a", "x");
  ::umask(before);
  struct stat now {};
  ASSERT_EQ(::stat((folder / "a").c_str(), &now), 0);
  EXPECT_EQ(now.st_mode & 07777, mode_t{0640});
}

TEST_F(AtomicFileTest, NamesThePlaceThatCannotBeWritten) {
  const auto missing = folder / "none/a";
  EXPECT_EQ(reason_of([&] { write_file_atomically(missing, "x"); }),
            missing.string() + ": cannot be written: No such file or directory");
  EXPECT_EQ(reason_of([&] { write_file_atomically(folder.path(), "x"); }),
            folder.path().string() + ": cannot be written: Is a directory");
  folder.write("file", "");
  const auto below = folder / "file/a";
  EXPECT_EQ(reason_of([&] { write_file_atomically(below, "x"); }),
            below.string() + ": cannot be written: Not a directory");
}

TEST_F(AtomicFileTest, WriteProtectionHolds) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const auto path = folder.write("a", "old");
  ASSERT_EQ(::chmod(path.c_str(), 0444), 0);
  EXPECT_EQ(reason_of([&] { write_file_atomically(path, "new"); }),
            path.string() + ": cannot be written: Permission denied");
  EXPECT_EQ(folder.read("a"), "old");
  fs::create_directory(folder / "closed");
  ASSERT_EQ(::chmod((folder / "closed").c_str(), 0555), 0);
  const auto inside = folder / "closed/a";
  EXPECT_EQ(reason_of([&] { write_file_atomically(inside, "new"); }),
            inside.string() + ": cannot be written: Permission denied");
}

TEST_F(AtomicFileTest, RefusesAnInputUnderAnyOfItsNames) {
  const auto input = folder.write("in", "x");
  fs::create_symlink("in", folder / "soft");
  fs::create_hard_link(input, folder / "hard");
  fs::create_directory(folder / "sub");
  for (const char* name : {"in", "soft", "hard", "sub/../in"})
    EXPECT_EQ(reason_of([&] { refuse_same_file(folder / name, input); }),
              (folder / name).string() + ": is an input and is not overwritten");
  EXPECT_NO_THROW(refuse_same_file(folder / "other", input));
}

}  // namespace
}  // namespace sir
