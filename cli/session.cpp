#include "cli/session.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "tracer/error.h"

namespace sir::cli {

void reserve_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    // The other way round than it is used. The lowest free number is the one that is given.
    if (::fcntl(stream, F_GETFD) < 0)
      (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size())
    throw FileError("standard output", 0,
                    std::string("cannot be written: ") + std::strerror(errno));
}

void flush_output() {
  if (std::fflush(stdout) != 0)
    throw FileError("standard output", 0,
                    std::string("cannot be written: ") + std::strerror(errno));
}

void note(const Session& session, std::string_view text) {
  if (!session.quiet) std::fprintf(stderr, "%.*s\n", static_cast<int>(text.size()), text.data());
}

void detail(const Session& session, std::string_view text) {
  if (session.verbose) note(session, text);
}

}  // namespace sir::cli
