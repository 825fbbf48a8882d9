#include "bench/child.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace sir::bench {
namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double seconds(const rusage& used) { return seconds(used.ru_utime) + seconds(used.ru_stime); }

}  // namespace

double own_cpu_seconds() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  return seconds(used);
}

std::optional<ChildUse> child_use(const std::vector<std::string>& words, const std::string& out) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0644);
  ::posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t process = -1;
  const bool started =
      ::posix_spawnp(&process, arguments[0], &files, nullptr, arguments.data(), environ) == 0;
  ::posix_spawn_file_actions_destroy(&files);
  if (!started) return {};
  int status = 0;
  rusage used{};
  while (::wait4(process, &status, 0, &used) < 0)
    if (errno != EINTR) return {};
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return {};
  return ChildUse{seconds(used), used.ru_maxrss};
}

std::optional<double> child_cpu_seconds(const std::vector<std::string>& words,
                                        const std::string& out) {
  const auto used = child_use(words, out);
  if (!used) return {};
  return used->cpu_seconds;
}

}  // namespace sir::bench
