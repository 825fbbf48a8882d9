#include "viewer/terminal.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <thread>

#include "tests/run_program.h"

namespace sir::viewer {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;

/// A terminal that is not ours, and the other end of its line.
class TerminalTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::terminals_exist()) GTEST_SKIP() << "no terminal to ask";
    master = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    ASSERT_GE(master, 0);
    ASSERT_EQ(::grantpt(master), 0);
    ASSERT_EQ(::unlockpt(master), 0);
    slave = ::open(::ptsname(master), O_RDWR | O_NOCTTY | O_CLOEXEC);
    ASSERT_GE(slave, 0);
    before = modes();
  }
  void TearDown() override {
    if (slave >= 0) ::close(slave);
    if (master >= 0) ::close(master);
  }

  termios modes() const {
    termios now{};
    EXPECT_EQ(::tcgetattr(slave, &now), 0);
    return now;
  }

  void expect_modes_as_before() const {
    const termios now = modes();
    EXPECT_EQ(now.c_lflag, before.c_lflag);
    EXPECT_EQ(now.c_iflag, before.c_iflag);
    EXPECT_EQ(now.c_oflag, before.c_oflag);
    EXPECT_EQ(0, std::memcmp(now.c_cc, before.c_cc, sizeof now.c_cc));
  }

  /// Waits for the question at the other end.
  std::string question() const {
    std::string got;
    char letter = 0;
    while (!got.ends_with('c') && ::read(master, &letter, 1) == 1) got += letter;
    return got;
  }
  void answer(std::string_view text) const {
    EXPECT_EQ(::write(master, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }

  int master = -1, slave = -1;
  termios before{};
};

TEST_F(TerminalTest, AsksAndGetsTheAnswerAmongOtherThings) {
  for (const char* before_it : {"", "x", "\x1b[?1u", "\x1b[A\x1b[?25"}) {
    std::string asked;
    termios meanwhile{};
    std::jthread other([&] {
      asked = question();
      meanwhile = modes();
      answer(before_it);
      answer("\x1b[?62;");
      answer("4;22c");
    });
    EXPECT_EQ(device_attributes(slave, minutes(2)), "\x1b[?62;4;22c") << before_it;
    other.join();
    EXPECT_EQ(asked, "\x1b[c");
    EXPECT_EQ(meanwhile.c_lflag & (ICANON | ECHO), 0u);
    expect_modes_as_before();
  }
}

TEST_F(TerminalTest, ASilentTerminalIsNotWaitedForForEver) {
  EXPECT_EQ(device_attributes(slave, milliseconds(50)), std::nullopt);
  expect_modes_as_before();
  EXPECT_EQ(device_attributes(slave, milliseconds(0)), std::nullopt);
  expect_modes_as_before();
}

TEST_F(TerminalTest, WhatIsNoAnswerIsNone) {
  std::jthread other([&] {
    question();
    answer("\x1b[62;4cc\x1b[?4x");
  });
  EXPECT_EQ(device_attributes(slave, milliseconds(300)), std::nullopt);
  expect_modes_as_before();
}

TEST_F(TerminalTest, AHungUpLineIsNoAnswer) {
  std::jthread other([&] {
    question();
    ::close(master);
    master = -1;
  });
  EXPECT_EQ(device_attributes(slave, minutes(2)), std::nullopt);
}

volatile sig_atomic_t signals = 0;
volatile sig_atomic_t raw_at_signal = 0;
int signalled_terminal = -1;

void on_signal(int) {
  signals = signals + 1;
  termios now{};
  ::tcgetattr(signalled_terminal, &now);
  raw_at_signal = (now.c_lflag & ICANON) == 0 ? 1 : 0;
}

// The handler that was there before is called, when the terminal is itself again.
TEST_F(TerminalTest, SignalsComeWhenTheTerminalIsRestored) {
  signalled_terminal = slave;
  for (const int number : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP}) {
    signals = 0;
    raw_at_signal = 0;
    struct sigaction own {
    }, old{};
    own.sa_handler = on_signal;
    ::sigaction(number, &own, &old);
    const pthread_t asking = ::pthread_self();
    std::jthread other([&] {
      question();
      ::pthread_kill(asking, number);
    });
    EXPECT_EQ(device_attributes(slave, minutes(2)), std::nullopt);
    other.join();
    struct sigaction after {};
    ::sigaction(number, &old, &after);
    EXPECT_EQ(after.sa_handler, &on_signal);
    EXPECT_EQ(signals, 1) << number;
    EXPECT_EQ(raw_at_signal, 0) << number;
    expect_modes_as_before();
  }
}

TEST_F(TerminalTest, KnowsItsWidth) {
  EXPECT_EQ(terminal_columns(slave), std::nullopt);  // 0: unknown
  winsize size{};
  size.ws_row = 30;
  size.ws_col = 132;
  ASSERT_EQ(::ioctl(master, TIOCSWINSZ, &size), 0);
  EXPECT_EQ(terminal_columns(slave), 132);
}

TEST(Terminal, WhatIsNoneIsNotAsked) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK), 0);
  EXPECT_EQ(device_attributes(ends[1], minutes(2)), std::nullopt);
  EXPECT_EQ(terminal_columns(ends[1]), std::nullopt);
  char letter = 0;
  EXPECT_EQ(::read(ends[0], &letter, 1), -1);  // nothing was sent
  for (const int end : ends) ::close(end);
}

TEST(Terminal, SixelIsAttribute4) {
  EXPECT_TRUE(has_sixel("\x1b[?62;4c"));
  EXPECT_TRUE(has_sixel("\x1b[?62;1;2;4;6;9;15;22c"));
  EXPECT_TRUE(has_sixel("\x1b[?63;22;4c"));
  // 4 alone is the kind of terminal, a VT132.
  for (const char* none : {"\x1b[?4c", "\x1b[?62;22c", "\x1b[?62;14;40;44c", "\x1b[?6c", "\x1b[?c",
                           "\x1b[?62;c", "", "c", "\x1b[62;4c", "\x1b[?62;99999999999999;5c"})
    EXPECT_FALSE(has_sixel(none)) << none;
}

}  // namespace
}  // namespace sir::viewer
