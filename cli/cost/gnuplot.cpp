#include "cli/cost/gnuplot.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <iterator>
#include <thread>

#include "cli/scratch_folder.h"
#include "tracer/error.h"

namespace sir::cli {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// Starts gnuplot with its streams in files; an error number, or 0.
int start(const fs::path& folder, pid_t& process) {
  const std::string script = folder / "script", svg = folder / "svg", said = folder / "said";
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&streams, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&streams, STDOUT_FILENO, svg.c_str(), kWrite, 0600);
  posix_spawn_file_actions_addopen(&streams, STDERR_FILENO, said.c_str(), kWrite, 0600);
  const char* const words[] = {"gnuplot", "-d", script.c_str(), nullptr};
  const int failure = ::posix_spawnp(&process, words[0], &streams, nullptr,
                                     const_cast<char* const*>(words), environ);
  posix_spawn_file_actions_destroy(&streams);
  return failure;
}

// Its status, or -1 where it took too long and was ended.
int wait_for(pid_t process) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::seconds(30);
  int status = 0;
  while (::waitpid(process, &status, WNOHANG) == 0) {
    if (Clock::now() > deadline) {
      ::kill(process, SIGKILL);
      ::waitpid(process, &status, 0);
      return -1;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return status;
}

std::string last_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);  // npos + 1 is 0
}

}  // namespace

Drawing draw(const std::string& script) {
  try {
    const ScratchFolder scratch;
    std::ofstream(scratch.path() / "script") << script << std::flush;
    pid_t process = -1;
    if (const int failure = start(scratch.path(), process); failure == ENOENT)
      return {"", "gnuplot is not installed"};
    else if (failure != 0)
      return {"", std::string("gnuplot cannot be started: ") + std::strerror(failure)};
    const int status = wait_for(process);
    Drawing drawing{content(scratch.path() / "svg"), ""};
    if (status != 0 || drawing.svg.empty())
      return {"", status == -1 ? "gnuplot took too long"
                               : "gnuplot failed: " + last_line(content(scratch.path() / "said"))};
    return drawing;
  } catch (const FileError& error) {
    return {"", std::string("gnuplot has no room to work: ") + error.what()};
  }
}

}  // namespace sir::cli
