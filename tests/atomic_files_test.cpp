// Files that change together, and what killed writers leave.
#include "tracer/atomic_files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/reason_of.h"
#include "tests/temp_folder.h"
#include "tracer/error.h"
#include "tracer/stale_temporaries.h"

namespace sir {
namespace {

using test::reason_of;
namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class AtomicFilesTest : public testing::Test {
 protected:
  // A writer that is killed before its commit.
  void leave_temporary(const fs::path& destination) const {
    const pid_t child = ::fork();
    if (child == 0) {
      AtomicFile file(destination);
      file.write("half");
      ::raise(SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
  }

  test::TempFolder folder;
};

TEST_F(AtomicFilesTest, AllShowAtOnceAndNoneWithoutCommit) {
  folder.write("a", "old");
  fs::create_directory(folder / "sub");
  {
    AtomicFiles files;
    AtomicFile& first = files.add(folder / "a");
    files.add(folder / "sub/b").write("new b");
    first.write("new a");
    EXPECT_EQ(folder.read("a"), "old");
    files.commit();
  }
  EXPECT_EQ(folder.read("a"), "new a");
  EXPECT_EQ(folder.read("sub/b"), "new b");
  {
    AtomicFiles files;
    files.add(folder / "a").write("newer");
    files.add(folder / "c").write("newer");
  }
  EXPECT_EQ(folder.read("a"), "new a");
  EXPECT_EQ(folder.list(), (Names{"a", "sub"}));
}

TEST_F(AtomicFilesTest, OneThatFailsLeavesAllAsTheyWere) {
  folder.write("a", "old");
  AtomicFiles files;
  files.add(folder / "a").write("new");
  EXPECT_EQ(reason_of([&] { files.add("/dev/full").write("x"); }),
            "/dev/full: cannot be written: No space left on device");
  EXPECT_EQ(reason_of([&] { files.add(folder / "none/b"); }),
            (folder / "none/b").string() + ": cannot be written: No such file or directory");
  EXPECT_EQ(folder.read("a"), "old");
}

TEST_F(AtomicFilesTest, WhatKilledWritersLeftGoesWithTheNextWriting) {
  const auto path = folder.write("a", "old");
  leave_temporary(path);
  leave_temporary(folder / "b");
  folder.write("a.sir-4000000000-0.tmp", "half");  // no process has such a number
  EXPECT_EQ(folder.list().size(), 4u);
  write_file_atomically(path, "new");
  const Names left = folder.list();
  ASSERT_EQ(left.size(), 2u);
  EXPECT_EQ(left[0], "a");
  EXPECT_TRUE(is_temporary_of(left[1], "b")) << left[1];
  write_file_atomically(folder / "b", "new");
  EXPECT_EQ(folder.list(), (Names{"a", "b"}));
}

TEST_F(AtomicFilesTest, WhatIsBeingWrittenStays) {
  AtomicFile first(folder / "a");
  first.write("first");
  write_file_atomically(folder / "a", "second");
  EXPECT_EQ(folder.list().size(), 2u);
  first.commit();
  EXPECT_EQ(folder.read("a"), "first");
}

TEST_F(AtomicFilesTest, WhatAnotherProcessIsWritingStays) {
  int pipe[2];
  ASSERT_EQ(::pipe(pipe), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    AtomicFile file(folder / "a");
    file.write("child");
    (void)!::write(pipe[1], "x", 1);
    ::pause();
  }
  char ready = 0;
  ASSERT_EQ(::read(pipe[0], &ready, 1), 1);
  write_file_atomically(folder / "a", "parent");
  EXPECT_EQ(folder.list().size(), 2u);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  write_file_atomically(folder / "a", "parent");
  EXPECT_EQ(folder.list(), Names{"a"});
  ::close(pipe[0]);
  ::close(pipe[1]);
}

TEST_F(AtomicFilesTest, FilesOfOtherNamesAndKindsStay) {
  const Names others{"a.123-4.tmp",     "a.sir--4.tmp",   "a.sir-1-2.tmp.old",
                     "a.sir-1-2-3.tmp", "a.sir-1x-2.tmp", "a.sir-12.tmp",
                     "aa.sir-1-2.tmp",  "a.sir-1-2.tm",   "x.a.sir-1-2.tmp"};
  for (const std::string& name : others) {
    EXPECT_FALSE(is_temporary_of(name, "a")) << name;
    folder.write(name, "x");
  }
  fs::create_directory(folder / "a.sir-1-2.tmp");
  ASSERT_EQ(::mkfifo((folder / "a.sir-1-3.tmp").c_str(), 0600), 0);
  fs::create_symlink("a.123-4.tmp", folder / "a.sir-1-4.tmp");
  folder.write("a.sir-1-5.tmp", "stale");
  write_file_atomically(folder / "a", "x");
  EXPECT_EQ(folder.list().size(), others.size() + 4);
  EXPECT_FALSE(folder.has("a.sir-1-5.tmp"));
  EXPECT_TRUE(folder.has("a.123-4.tmp"));
}

TEST_F(AtomicFilesTest, ALeftoverOfOurOwnProcessNumberIsNoObstacle) {
  // The names that this process takes next.
  std::string next = temporary_beside(folder / "a").filename();
  const std::string head = next.substr(0, next.rfind('-') + 1);
  const int serial = std::stoi(next.substr(head.size()));
  for (int i = 1; i <= 3; ++i) folder.write(head + std::to_string(serial + i) + ".tmp", "stale");
  write_file_atomically(folder / "a", "new");
  EXPECT_EQ(folder.read("a"), "new");
  EXPECT_EQ(folder.list(), Names{"a"});
}

TEST_F(AtomicFilesTest, AWriterThatIsTakenForGoneMakesAnotherFile) {
  // What remove_stale_temporaries() does between another's open() and its lock.
  const auto path = folder / "t";
  const auto create = [&] { return ::open(path.c_str(), O_WRONLY | O_CREAT, 0600); };
  const int mine = create();
  const int theirs = ::open(path.c_str(), O_WRONLY);
  ASSERT_EQ(::flock(theirs, LOCK_EX | LOCK_NB), 0);
  EXPECT_FALSE(mark_as_written(mine));
  ::unlink(path.c_str());
  ::close(theirs);
  EXPECT_FALSE(mark_as_written(mine));
  ::close(mine);
  const int another = create();
  EXPECT_TRUE(mark_as_written(another));
  ::close(another);
}

TEST_F(AtomicFilesTest, TheCheckBeforehandFindsWhatWritingFinds) {
  folder.write("file", "old");
  EXPECT_NO_THROW(require_writable(folder / "file"));
  EXPECT_NO_THROW(require_writable(folder / "new"));
  EXPECT_NO_THROW(require_writable("/dev/null"));
  EXPECT_EQ(folder.read("file"), "old");
  EXPECT_EQ(folder.list(), Names{"file"});
  for (const fs::path& path : {folder / "none/a", folder / "file/a", folder.path()}) {
    const std::string found = reason_of([&] { require_writable(path); });
    EXPECT_EQ(found, reason_of([&] { write_file_atomically(path, "x"); }));
    EXPECT_NE(found, "no error");
  }
}

TEST_F(AtomicFilesTest, TheCheckBeforehandDoesNotOpenAPipe) {
  const auto path = folder / "pipe";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  require_writable(path);  // would wait for a reader
  EXPECT_TRUE(fs::is_fifo(path));
}

TEST_F(AtomicFilesTest, ANewFileMayBeItsOwnersAlone) {
  { AtomicFile(folder / "a", 0600).commit(); }
  struct stat now {};
  ASSERT_EQ(::stat((folder / "a").c_str(), &now), 0);
  EXPECT_EQ(now.st_mode & 07777, mode_t{0600});
}

}  // namespace
}  // namespace sir
