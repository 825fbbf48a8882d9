// Outputs that cannot be written, of every subcommand: reported, and what was there is there.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "tests/own_mounts.h"
#include "tests/writing_commands.h"

namespace sir::test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class NothingLost : public WritingTest {};

TEST_F(NothingLost, OnAFullDisk) {
  // Once for each page that is free, so that each file of each command is the one that does not
  // fit; until it all does.
  constexpr int kDisk = 512, kMostPages = 64;
  const Elsewhere there = with_own_mounts(folder / "o", [&] {
    for (const WritingCommand& command : writing_commands()) {
      const auto made = made_by(command);
      ASSERT_TRUE(mount_small_disk(folder / "o", kDisk));
      int failures = 0;
      for (int pages = 0;; ++pages) {
        ASSERT_LT(pages, kMostPages) << command.name;
        make_old(command);
        ASSERT_TRUE(fill_disk(folder / "o", "filler", pages)) << command.name;
        const Ended ended = sir(command.words);
        if (ended.exit_code == 0) break;
        ++failures;
        expect_failed(command, ended, "cannot be written: No space left on device");
        expect_nothing_lost(command, made);
        if (HasFailure()) return;
      }
      EXPECT_GE(failures, command.together ? static_cast<int>(command.outputs.size()) : 1)
          << command.name;
      unmount(folder / "o");
    }
  });
  if (!there.possible) GTEST_SKIP() << "no disk of its own: " << there.why_not;
  EXPECT_TRUE(there.passed);
}

TEST_F(NothingLost, PastALimitOnFileSizes) {
  constexpr rlim_t kBytes = 8;  // less than each command's first file
  for (const WritingCommand& command : writing_commands()) {
    const auto made = made_by(command);
    make_old(command);
    rlimit old{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
    rlimit small = old;
    small.rlim_cur = kBytes;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const Ended ended = sir(command.words);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old), 0);
    expect_failed(command, ended, "cannot be written: File too large");
    expect_nothing_lost(command, made);
  }
}

TEST_F(NothingLost, OnAReadOnlyDisk) {
  const Elsewhere there = with_own_mounts(folder / "o", [&] {
    for (const WritingCommand& command : writing_commands()) {
      ASSERT_TRUE(mount_small_disk(folder / "o", 512));
      make_old(command);
      ASSERT_TRUE(make_read_only(folder / "o"));
      expect_failed(command, sir(command.words), "cannot be written: Read-only file system");
      expect_nothing_lost(command, {});
      unmount(folder / "o");
    }
  });
  if (!there.possible) GTEST_SKIP() << "no disk of its own: " << there.why_not;
  EXPECT_TRUE(there.passed);
}

TEST_F(NothingLost, InAReadOnlyFolderAndOverAReadOnlyFile) {
  const Elsewhere there = without_privileges([&] {
    for (const WritingCommand& command : writing_commands()) {
      make_old(command);
      ASSERT_EQ(::chmod((folder / "o").c_str(), 0555), 0);
      expect_failed(command, sir(command.words), "cannot be written: Permission denied");
      ASSERT_EQ(::chmod((folder / "o").c_str(), 0755), 0);
      expect_nothing_lost(command, {});
      if (!command.together) continue;
      // The last: it must be known before the first is renamed.
      const std::string& last = command.outputs.back();
      ASSERT_EQ(::chmod((folder / ("o/" + last)).c_str(), 0444), 0);
      expect_failed(command, sir(command.words), last + ": cannot be written: Permission denied");
      expect_nothing_lost(command, {});
    }
  });
  if (!there.possible) GTEST_SKIP() << "permissions do not hold: " << there.why_not;
  EXPECT_TRUE(there.passed);
}

TEST_F(NothingLost, OnADeviceThatIsFull) {
  for (const WritingCommand& command : writing_commands())
    for (const std::string& full : command.outputs) {
      // By a link, so that one of several files may be the device, whatever its name.
      make_old(command);
      fs::remove(folder / ("o/" + full));
      fs::create_symlink("/dev/full", folder / ("o/" + full));
      const Ended ended = sir(command.words);
      expect_failed(command, ended, full + ": cannot be written: No space left on device");
      EXPECT_TRUE(fs::is_symlink(folder / ("o/" + full)));
      EXPECT_TRUE(fs::is_character_file("/dev/full"));
      if (!command.together) continue;
      for (const std::string& other : command.outputs)
        EXPECT_TRUE(other == full || folder.read("o/" + other) == "old") << command.name << other;
    }
}

TEST_F(NothingLost, APipeStaysAPipeAndGetsTheSameBytes) {
  for (const WritingCommand& command : writing_commands())
    for (const std::string& piped : command.outputs) {
      if (!command.same_bytes || !command.together) continue;
      const auto made = made_by(command);
      make_old(command);
      const fs::path pipe = folder / ("o/" + piped);
      fs::remove(pipe);
      ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
      const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
      const Ended ended = sir(command.words);
      EXPECT_EQ(ended.exit_code, 0) << command.name << ended.err;
      std::string got(1 << 16, ' ');  // as much as a pipe holds
      const ssize_t size = ::read(reader, got.data(), got.size());
      got.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
      ::close(reader);
      EXPECT_EQ(got, made.at(piped)) << command.name << ": " << piped;
      EXPECT_TRUE(fs::is_fifo(pipe));
      for (const std::string& other : command.outputs) {
        if (other == piped) continue;
        EXPECT_EQ(folder.read("o/" + other), made.at(other)) << command.name;
      }
    }
}

TEST_F(NothingLost, WhereStandardOutputCannotBeWritten) {
  std::vector<Names> telling{{"--help"},
                             {"--version"},
                             {"check", "s"},
                             {"effects", "s", "--repeats", "1"},
                             {"trace", "s", "0", "0"},
                             {"why", "s.png", "3", "4"},
                             {"probe", "s"},
                             {"hsv"},
                             {"model", "-"},
                             {"model", "--from", "s"},
                             {"show", "s.png", "--terminal=blocks"},
                             {"metrics", "s.png", "s.png"}};
  for (const WritingCommand& command : writing_commands())
    if (!command.tells_nothing) telling.push_back(command.words);
  for (const Names& words : telling) {
    Start full, closed;
    full.in = closed.in = words[0] == "model" ? "list\nhelp\n" : "1 2 3\n";
    full.out_file = "/dev/full";
    closed.out_closed = true;
    const auto expect_told = [&](const Ended& ended, const std::string& reason) {
      EXPECT_EQ(ended.exit_code, 1) << testing::PrintToString(words) << ended.err;
      EXPECT_NE(ended.err.find("sir: standard output: cannot be written: " + reason),
                std::string::npos)
          << testing::PrintToString(words) << ended.err;
    };
    expect_told(sir(words, full), "No space left on device");
    expect_told(sir(words, closed), "Broken pipe");
    // Closed from the start: an output file must not get its number.
    closed.folder = folder.path();
    Names shell{"-c", "exec \"$0\" \"$@\" >&-", SIR_PROGRAM};
    shell.insert(shell.end(), words.begin(), words.end());
    closed.out_closed = false;
    expect_told(Program("/bin/sh", shell, closed).finish(), "Bad file descriptor");
  }
}

TEST_F(NothingLost, NotesDoNotGoIntoAnOutputWhereStandardErrorIsClosed) {
  for (const WritingCommand& command : writing_commands()) {
    const auto made = made_by(command);
    make_old(command);
    Start start;
    start.folder = folder.path();
    // Without PATH `cost` finds no gnuplot, and says so between its two files.
    Names shell{"-c", "PATH=; exec \"$0\" -v \"$@\" 2>&-", SIR_PROGRAM};
    shell.insert(shell.end(), command.words.begin(), command.words.end());
    EXPECT_EQ(Program("/bin/sh", shell, start).finish().exit_code, 0) << command.name;
    const auto now = found(command);
    if (command.same_bytes) {
      EXPECT_EQ(now, made) << command.name;
    }
    for (const auto& [name, bytes] : now)
      EXPECT_EQ(bytes.substr(0, 4), made.at(name).substr(0, 4)) << command.name << ": " << name;
  }
}

}  // namespace
}  // namespace sir::test
