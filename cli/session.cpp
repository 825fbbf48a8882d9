#include "cli/session.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "tracer/error.h"

namespace sir::cli {

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
