#include "cli/line_input.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "cli/interrupt.h"
#include "tracer/error.h"

namespace sir::cli {

bool for_each_line(int descriptor,
                   const std::function<void(std::string_view line, bool too_long)>& answer,
                   const std::function<void()>& flush) {
  std::vector<char> chunk(std::size_t{1} << 18);
  std::string rest;  // of a line whose end has not come yet
  bool too_long = false;
  const auto keep = [&](std::string_view part) {
    if (too_long) return;
    too_long = rest.size() + part.size() > kLongestLine;
    if (!too_long) rest.append(part);
    else answer({}, true);  // now: its end may never come
  };
  const auto finish = [&] {
    if (!too_long) answer(rest, false);
    rest.clear();
    too_long = false;
  };
  while (true) {
    // read() gives what a pipe holds, where fread would wait for a full buffer.
    const ssize_t got = ::read(descriptor, chunk.data(), chunk.size());
    if (interrupted()) return false;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0)
      throw FileError("standard input", 0, std::string("cannot be read: ") + std::strerror(errno));
    if (got == 0) break;
    std::string_view piece(chunk.data(), static_cast<std::size_t>(got));
    for (auto end = piece.find('\n'); end != std::string_view::npos; end = piece.find('\n')) {
      keep(piece.substr(0, end));
      finish();
      piece.remove_prefix(end + 1);
    }
    keep(piece);
    flush();
  }
  if (!rest.empty()) finish();
  flush();
  return true;
}

}  // namespace sir::cli
