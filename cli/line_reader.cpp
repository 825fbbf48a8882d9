#include "cli/line_reader.h"

#include <unistd.h>

#include <cerrno>

#include "cli/input_wait.h"
#include "cli/session.h"
#include "modeler/state_folder.h"
#include "tracer/error.h"

namespace sir::cli {
namespace {

class PlainReader : public LineReader {
 public:
  explicit PlainReader(std::string prompt) : prompt_(std::move(prompt)) {}

  std::optional<std::string> read() override {
    print(prompt_);
    flush_output();
    std::string line;
    // Byte by byte: a terminal gives lines, and what comes after one is not ours to keep.
    for (char letter = 0;;) {
      if (!wait_for_input(STDIN_FILENO)) return std::nullopt;
      const ssize_t got = ::read(STDIN_FILENO, &letter, 1);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return line.empty() || got < 0 ? std::nullopt : std::optional(line);
      if (letter == '\n') return line;
      line += letter;
    }
  }

 private:
  std::string prompt_;
};

}  // namespace

std::unique_ptr<LineReader> make_plain_reader(const LineOptions& options) {
  return std::make_unique<PlainReader>(options.prompt);
}

std::filesystem::path history_file() {
  const std::filesystem::path folder = modeler::state_folder();
  if (folder.empty()) return {};
  try {
    modeler::make_state_folder(folder);
  } catch (const FileError&) {
    return {};  // lines are not kept, then
  }
  return folder / "history";
}

}  // namespace sir::cli
