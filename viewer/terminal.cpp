#include "viewer/terminal.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>

namespace sir::viewer {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

// Terminals answer within milliseconds; over a slow line within a round trip.
constexpr milliseconds kPatience{1000};

volatile sig_atomic_t arrived = 0;

extern "C" void remember_signal(int number) { arrived = number; }

// Signals that would end or stop us come only after this is gone. This thread takes them, and only
// while it waits (mask_to_wait), so that none slips in between a look at `arrived` and the wait.
class SignalsHeld {
 public:
  SignalsHeld() {
    arrived = 0;
    sigset_t ours;
    sigemptyset(&ours);
    for (const int number : kNumbers) sigaddset(&ours, number);
    ::pthread_sigmask(SIG_BLOCK, &ours, &mask_);
    struct sigaction remember {};
    remember.sa_handler = remember_signal;
    for (std::size_t i = 0; i < kNumbers.size(); ++i)
      ::sigaction(kNumbers[i], &remember, &before_[i]);
  }
  ~SignalsHeld() {
    for (std::size_t i = 0; i < kNumbers.size(); ++i)
      ::sigaction(kNumbers[i], &before_[i], nullptr);
    if (arrived != 0) ::raise(arrived);
    ::pthread_sigmask(SIG_SETMASK, &mask_, nullptr);
  }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

  const sigset_t& mask_to_wait() const { return mask_; }

 private:
  static constexpr std::array kNumbers{SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP};
  std::array<struct sigaction, kNumbers.size()> before_{};
  sigset_t mask_{};
};

// No echo, and bytes as they come.
class RawMode {
 public:
  explicit RawMode(int descriptor) : descriptor_(descriptor) {
    if (::tcgetattr(descriptor, &before_) != 0) return;
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    raw.c_cc[VMIN] = 0;
    raw.c_cc[VTIME] = 0;
    on_ = ::tcsetattr(descriptor, TCSANOW, &raw) == 0;
  }
  // With the rest of a late answer thrown away.
  ~RawMode() {
    if (on_) ::tcsetattr(descriptor_, TCSAFLUSH, &before_);
  }
  RawMode(const RawMode&) = delete;
  RawMode& operator=(const RawMode&) = delete;

  bool on() const { return on_; }

 private:
  int descriptor_;
  termios before_{};
  bool on_ = false;
};

// A process in the background that sets a terminal is stopped.
bool may_ask(int descriptor) {
  if (::isatty(descriptor) != 1) return false;
  const pid_t front = ::tcgetpgrp(descriptor);
  return front < 0 || front == ::getpgrp();
}

bool send(int descriptor, std::string_view text) {
  return ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
}

// "ESC [ ? numbers c" within what has come so far.
std::optional<std::string> find_answer(const std::string& got) {
  constexpr std::string_view kStart = "\x1b[?";
  for (auto at = got.find(kStart); at != std::string::npos; at = got.find(kStart, at + 1)) {
    const auto end = got.find_first_not_of("0123456789;", at + kStart.size());
    if (end != std::string::npos && got[end] == 'c') return got.substr(at, end + 1 - at);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> device_attributes(int descriptor, milliseconds patience) {
  if (!may_ask(descriptor)) return std::nullopt;
  const SignalsHeld held;  // outlives the raw mode
  const RawMode raw(descriptor);
  if (!raw.on() || !send(descriptor, "\x1b[c")) return std::nullopt;
  const auto end = steady_clock::now() + patience;
  std::string got;
  while (arrived == 0) {
    const auto left = std::chrono::ceil<milliseconds>(end - steady_clock::now());
    if (left.count() <= 0) return std::nullopt;
    pollfd ready{descriptor, POLLIN, 0};
    const timespec limit{static_cast<time_t>(left.count() / 1000),
                         static_cast<long>(left.count() % 1000) * 1'000'000};
    const int count = ::ppoll(&ready, 1, &limit, &held.mask_to_wait());
    if (count < 0 && errno != EINTR) return std::nullopt;
    if (count <= 0) continue;
    std::array<char, 256> chunk;
    const ssize_t size = ::read(descriptor, chunk.data(), chunk.size());
    if (size <= 0) return std::nullopt;  // the line is cut
    got.append(chunk.data(), static_cast<std::size_t>(size));
    if (auto answer = find_answer(got)) return answer;
  }
  return std::nullopt;
}

bool has_sixel(std::string_view answer) {
  constexpr int kSixelGraphics = 4;
  if (!answer.starts_with("\x1b[?")) return false;
  answer.remove_prefix(3);
  // The first number is the kind of terminal, the others are what it can do.
  for (bool first = true;; first = false) {
    int number = 0;
    const auto [end, error] = std::from_chars(answer.data(), answer.data() + answer.size(), number);
    if (error == std::errc() && !first && number == kSixelGraphics) return true;
    answer.remove_prefix(static_cast<std::size_t>(end - answer.data()));
    if (!answer.starts_with(';')) return false;
    answer.remove_prefix(1);
  }
}

bool terminal_has_sixel() {
  const int descriptor = ::open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const auto answer = device_attributes(descriptor, kPatience);
  ::close(descriptor);
  return answer && has_sixel(*answer);
}

std::optional<int> terminal_columns(int descriptor) {
  winsize size{};
  if (::ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::nullopt;
  return size.ws_col;
}

}  // namespace sir::viewer
