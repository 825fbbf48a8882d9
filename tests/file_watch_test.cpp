#include "viewer/file_watch.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "tests/temp_folder.h"
#include "tracer/atomic_file.h"

namespace sir::viewer {
namespace {

namespace fs = std::filesystem;
using test::TempFolder;

constexpr std::chrono::hours kLong{1};

class FileWatchTest : public testing::Test {
 protected:
  FileWatchTest() {
    folder.write("a", "one");
    folder.write("b", "two");
    settle();
  }

  void look() { watch.look({folder / "a", folder / "b"}); }

  void settle() {
    look();
    look();
    ASSERT_TRUE(watch.ready());
    watch.take();
  }

  // A change that is noticed at the next look and at rest with the one after.
  void expect_change() {
    look();
    EXPECT_TRUE(watch.changed());
    EXPECT_FALSE(watch.ready());
    look();
    EXPECT_TRUE(watch.ready());
    watch.take();
    look();
    EXPECT_FALSE(watch.changed());
  }

  TempFolder folder;
  FileWatch watch{kLong};
};

TEST_F(FileWatchTest, NothingHappensWithoutAChange) {
  for (int i = 0; i < 10; ++i) {
    look();
    EXPECT_FALSE(watch.changed());
  }
}

TEST_F(FileWatchTest, FilesThatNobodyTouchedAreAtRestAtOnce) {
  FileWatch at_once(std::chrono::nanoseconds(-kLong));
  at_once.look({folder / "a"});
  EXPECT_TRUE(at_once.ready());
  FileWatch in_doubt(kLong);
  in_doubt.look({folder / "a"});
  EXPECT_FALSE(in_doubt.ready());
  FileWatch missing(kLong);
  missing.look({folder / "none"});
  EXPECT_TRUE(missing.ready());
}

TEST_F(FileWatchTest, WritingInPlaceIsNoticedEachTime) {
  for (const char* text : {"three", "four", "fifth", "", "sixth"}) {
    folder.write("b", text);
    expect_change();
  }
}

TEST_F(FileWatchTest, RenamingIsNoticed) {
  for (const char* text : {"aaa", "bbb", "aaa"}) {
    write_file_atomically(folder / "a", text);
    expect_change();
  }
}

// As within one tick of the file system's clock.
TEST_F(FileWatchTest, OtherContentsOfTheSameTimeAndLengthAreNoticed) {
  const auto time = fs::last_write_time(folder / "a");
  for (const char* text : {"ONE", "Uno", "uno"}) {
    folder.write("a", text);
    fs::last_write_time(folder / "a", time);
    expect_change();
  }
}

TEST_F(FileWatchTest, TheSameContentsAgainOfTheSameTimeAreNoChange) {
  const auto time = fs::last_write_time(folder / "a");
  folder.write("a", "one");
  fs::last_write_time(folder / "a", time);
  look();
  EXPECT_FALSE(watch.changed());
}

TEST_F(FileWatchTest, GoingAndComingAreChanges) {
  fs::rename(folder / "a", folder / "away");
  expect_change();
  fs::rename(folder / "away", folder / "a");
  expect_change();
}

TEST_F(FileWatchTest, AChangeThatGoesOnIsNotAtRest) {
  for (const char* text : {"1", "22", "333", "4444"}) {
    folder.write("a", text);
    look();
    EXPECT_TRUE(watch.changed());
    EXPECT_FALSE(watch.ready());
  }
  look();
  EXPECT_TRUE(watch.ready());
}

TEST_F(FileWatchTest, OtherFilesAreAChange) {
  watch.look({folder / "a"});
  EXPECT_TRUE(watch.changed());
}

TEST_F(FileWatchTest, AChangeCanBePretended) {
  watch.pretend_change();
  EXPECT_TRUE(watch.ready());
}

// Opening it would wait for a writer.
TEST_F(FileWatchTest, APipeIsNotOpened) {
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  FileWatch pipe(kLong);
  pipe.look({folder / "pipe"});
  pipe.look({folder / "pipe"});
  EXPECT_TRUE(pipe.ready());
}

}  // namespace
}  // namespace sir::viewer
