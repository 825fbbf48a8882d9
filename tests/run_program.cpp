#include "tests/run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <stdexcept>

namespace sir::test {
namespace {

struct Pipe {
  int read_end = -1, write_end = -1;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  return {ends[0], ends[1]};
}

// The terminal's two sides as a pipe's: what is written to one is read from the other.
Pipe make_terminal() {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (master < 0 || ::grantpt(master) != 0 || ::unlockpt(master) != 0)
    throw std::runtime_error("no terminal");
  const int slave = ::open(::ptsname(master), O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (slave < 0) throw std::runtime_error("no terminal");
  return {master, slave};
}

// False at the end of the stream.
bool read_some(int descriptor, std::string& text) {
  std::array<char, 1 << 16> chunk;
  const ssize_t got = ::read(descriptor, chunk.data(), chunk.size());
  if (got > 0) text.append(chunk.data(), static_cast<std::size_t>(got));
  return got > 0 || (got < 0 && errno == EINTR);  // a terminal ends with EIO
}

void close_one(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

}  // namespace

bool terminals_exist() {
  try {
    Pipe terminal = make_terminal();
    close_one(terminal.read_end);
    close_one(terminal.write_end);
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

Program::Program(const std::string& path, const std::vector<std::string>& arguments,
                 const Start& start)
    : in_(start.in), keep_in_open_(start.keep_in_open) {
  ::signal(SIGPIPE, SIG_IGN);  // a program need not read its input
  const Pipe in = make_pipe();
  Pipe out = make_pipe();
  if (start.out_closed) close_one(out.read_end);  // before the program can write
  const Pipe err = start.err_is_terminal ? make_terminal() : make_pipe();
  std::vector<char*> words{const_cast<char*>(path.c_str())};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);

  process_ = ::fork();
  if (process_ < 0) throw std::runtime_error("no process");
  if (process_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::signal(SIGPIPE, SIG_DFL);
    const int to_file =
        start.out_file.empty() ? out.write_end : ::open(start.out_file.c_str(), O_WRONLY);
    if (!start.folder.empty() && ::chdir(start.folder.c_str()) != 0) ::_exit(126);
    ::dup2(start.in_file.empty() ? in.read_end : ::open(start.in_file.c_str(), O_RDONLY),
           STDIN_FILENO);
    ::dup2(to_file, STDOUT_FILENO);
    ::dup2(err.write_end, STDERR_FILENO);
    ::execv(path.c_str(), words.data());
    ::_exit(127);
  }
  ::close(in.read_end);
  ::close(out.write_end);
  ::close(err.write_end);
  in_pipe_ = in.write_end;
  out_pipe_ = out.read_end;
  err_pipe_ = err.read_end;
  ::fcntl(in_pipe_, F_SETFL, O_NONBLOCK);
}

Program::~Program() {
  close_all();
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void Program::close_all() {
  close_one(in_pipe_);
  close_one(out_pipe_);
  close_one(err_pipe_);
}

// Moves what can be moved; false when both outputs have ended.
bool Program::pump() {
  if (in_.empty() && !keep_in_open_) close_one(in_pipe_);
  if (out_pipe_ < 0 && err_pipe_ < 0) return false;
  // poll() passes over negative descriptors.
  std::array<pollfd, 3> ready{
      {{in_.empty() ? -1 : in_pipe_, POLLOUT, 0}, {out_pipe_, POLLIN, 0}, {err_pipe_, POLLIN, 0}}};
  if (::poll(ready.data(), ready.size(), -1) < 0) return errno == EINTR;
  if (ready[0].revents != 0) {
    const ssize_t sent = ::write(in_pipe_, in_.data(), in_.size());
    if (sent > 0) in_.erase(0, static_cast<std::size_t>(sent));
    if (sent < 0 && errno != EAGAIN && errno != EINTR) in_.clear();
  }
  if (ready[1].revents != 0 && !read_some(out_pipe_, ended_.out)) close_one(out_pipe_);
  if (ready[2].revents != 0 && !read_some(err_pipe_, ended_.err)) close_one(err_pipe_);
  return true;
}

bool Program::wait_for(std::string_view text) {
  const auto seen = [&] {
    return ended_.out.find(text) != std::string::npos || ended_.err.find(text) != std::string::npos;
  };
  while (!seen() && pump()) {
  }
  return seen();
}

void Program::signal(int number) const { ::kill(process_, number); }

Ended Program::finish() {
  keep_in_open_ = false;
  while (pump()) {
  }
  close_all();
  int status = 0;
  struct rusage used {};
  while (::wait4(process_, &status, 0, &used) < 0 && errno == EINTR) {
  }
  process_ = -1;
  ended_.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  ended_.peak_kilobytes = used.ru_maxrss;
  return ended_;
}

Ended run_sir(const std::vector<std::string>& arguments, const Start& start) {
  return Program(SIR_PROGRAM, arguments, start).finish();
}

}  // namespace sir::test
