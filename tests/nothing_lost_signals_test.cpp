// Signals during every subcommand that writes, and a kill while its files are being written.
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <utility>

#include "tests/writing_commands.h"
#include "tracer/stale_temporaries.h"

namespace sir::test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class NothingLostBySignals : public WritingTest {
 protected:
  Start here() const {
    Start start;
    start.folder = folder.path();
    return start;
  }

  std::size_t temporaries() const {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder / "o"))
      count += entry.path().extension() == ".tmp";
    return count;
  }
};

// The input that a command waits for where it is a pipe.
std::string input_of(const WritingCommand& command) {
  if (command.name == "render" || command.name == "export" || command.name == "cost")
    return "s.CSG";
  if (command.name == "model") return "all.model";
  return command.name == "replay" ? "s.trace" : "s.png";
}

TEST_F(NothingLostBySignals, ASignalEndsEachCommandWith130) {
  for (const WritingCommand& command : writing_commands()) {
    if (command.name == "planes") continue;  // reads planes, which cannot be a pipe
    const std::string input = input_of(command);
    const std::string content = folder.read(input);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
      make_old(command);
      fs::remove(folder / input);
      ASSERT_EQ(::mkfifo((folder / input).c_str(), 0600), 0);
      Program program(SIR_PROGRAM, command.words, here());
      const int writer = ::open((folder / input).c_str(), O_WRONLY);  // when it has begun to read
      program.signal(number);
      ::close(writer);
      EXPECT_EQ(program.finish().exit_code, 130) << command.name << number;
      expect_nothing_lost(command, {});
      fs::remove(folder / input);
      folder.write(input, content);
    }
  }
}

TEST_F(NothingLostBySignals, HangingUpEndsNothingThatWasToldToStay) {
  const std::string picture = folder.read("s.png");
  fs::remove(folder / "s.png");
  ASSERT_EQ(::mkfifo((folder / "s.png").c_str(), 0600), 0);
  Program program("/bin/sh", {"-c", "trap '' HUP; exec \"$0\" lut s.png -o o/x.LUT", SIR_PROGRAM},
                  here());
  const int writer = ::open((folder / "s.png").c_str(), O_WRONLY);
  program.signal(SIGHUP);
  ASSERT_EQ(::write(writer, picture.data(), picture.size()), static_cast<ssize_t>(picture.size()));
  ::close(writer);
  EXPECT_EQ(program.finish().exit_code, 0);
  EXPECT_TRUE(folder.has("o/x.LUT"));
}

// A render whose PNG goes into a pipe that nobody empties: its planes are written and have not
// yet taken their names.
class WhileWriting : public NothingLostBySignals {
 protected:
  WhileWriting() {
    for (const char* plane : {"s.R", "s.G", "s.B"}) folder.write(std::string("o/") + plane, "old");
    EXPECT_EQ(::mkfifo(png.c_str(), 0600), 0);
    open_reader();
  }
  ~WhileWriting() override { ::close(reader); }

  // Anew: without what another writer left.
  void open_reader() {
    ::close(reader);
    reader = ::open(png.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    constexpr int kPage = 4096;  // the least that a pipe holds, and less than the PNG
    EXPECT_GE(::fcntl(reader, F_SETPIPE_SZ, kPage), kPage);
  }

  // Once the PNG has begun to come.
  void wait_for_writing() const {
    pollfd ready{reader, POLLIN, 0};
    while (::poll(&ready, 1, -1) < 0) {
    }
  }

  void expect_old_planes() const {
    for (const char* plane : {"s.R", "s.G", "s.B"})
      EXPECT_EQ(folder.read(std::string("o/") + plane), "old") << plane;
  }

  const Names words{"render", "s", "--size", "1600x1200", "--out", "o", "-q"};
  const fs::path png = folder / "o/s.png";
  int reader = -1;
};

TEST_F(WhileWriting, TwoSignalsLeaveNoTemporaries) {
  // Two of a kind might arrive as one.
  for (const auto& [first, second] :
       {std::pair{SIGINT, SIGTERM}, {SIGTERM, SIGHUP}, {SIGHUP, SIGINT}}) {
    Program program(SIR_PROGRAM, words, here());
    wait_for_writing();
    EXPECT_EQ(temporaries(), 3u);
    expect_old_planes();
    program.signal(first);
    program.signal(second);
    EXPECT_EQ(program.finish().exit_code, 130);
    EXPECT_EQ(temporaries(), 0u);
    expect_old_planes();
    EXPECT_TRUE(fs::is_fifo(png));
    open_reader();
  }
}

TEST_F(WhileWriting, AKillLeavesTheOldPlanesAndTheNextRunClearsUp) {
  Program program(SIR_PROGRAM, words, here());
  wait_for_writing();
  program.signal(SIGKILL);
  EXPECT_EQ(program.finish().exit_code, 128 + SIGKILL);
  EXPECT_EQ(temporaries(), 3u);
  expect_old_planes();
  fs::remove(png);
  EXPECT_EQ(sir(words).exit_code, 0);
  EXPECT_EQ(temporaries(), 0u);
  for (const char* plane : {"s.R", "s.G", "s.B"})
    EXPECT_EQ(folder.read(std::string("o/") + plane).size(), 1600u * 1200u) << plane;
}

TEST_F(WhileWriting, AReaderThatLeavesIsReported) {
  Program program(SIR_PROGRAM, words, here());
  wait_for_writing();
  ::close(std::exchange(reader, -1));
  expect_failure(program.finish(), "o/s.png: cannot be written: Broken pipe");
  EXPECT_EQ(temporaries(), 0u);
  expect_old_planes();
}

}  // namespace
}  // namespace sir::test
