#include "tests/at_terminal.h"

#include <pty.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utmp.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <stdexcept>

namespace sir::test {

AtTerminal::AtTerminal(const std::vector<std::string>& arguments,
                       const std::filesystem::path& folder, int columns) {
  std::string program = SIR_PROGRAM;
  std::vector<char*> words{program.data()};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  winsize size{};
  size.ws_row = 25;
  size.ws_col = static_cast<unsigned short>(columns);
  int end = -1;  // the program's
  if (::openpty(&line_, &end, nullptr, nullptr, &size) != 0 || ::tcgetattr(end, &at_first_) != 0)
    throw std::runtime_error("no terminal");
  process_ = ::fork();
  if (process_ < 0) throw std::runtime_error("no process");
  if (process_ == 0) {
    ::close(line_);
    if (::login_tty(end) != 0) ::_exit(126);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::chdir(folder.c_str()) != 0) ::_exit(126);
    ::execv(program.c_str(), words.data());
    ::_exit(127);
  }
  ::close(end);
}

AtTerminal::~AtTerminal() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  ::close(line_);
}

// False when the program has let go of its terminal.
bool AtTerminal::pump() {
  std::array<char, 1 << 16> chunk;
  const ssize_t size = ::read(line_, chunk.data(), chunk.size());
  if (size > 0) got_.append(chunk.data(), static_cast<std::size_t>(size));
  return size > 0 || (size < 0 && errno == EINTR);
}

bool AtTerminal::wait_for(const std::string& text) {
  while (got_.find(text) == std::string::npos)
    if (!pump()) return false;
  return true;
}

void AtTerminal::type(const std::string& text) const {
  if (::write(line_, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
    throw std::runtime_error("the terminal takes nothing");
}

void AtTerminal::signal(int number) const { ::kill(process_, number); }

termios AtTerminal::modes() const {
  termios now{};
  if (::tcgetattr(line_, &now) != 0) throw std::runtime_error("the terminal is gone");
  return now;
}

int AtTerminal::finish() {
  while (pump()) {
  }
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string AtTerminal::shown() const {
  std::string text = got_;
  text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
  return text;
}

}  // namespace sir::test
