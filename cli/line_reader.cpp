#include "cli/line_reader.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "cli/input_wait.h"
#include "cli/session.h"

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
  const auto variable = [](const char* name) -> std::filesystem::path {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
  };
  std::filesystem::path folder = variable("XDG_STATE_HOME");
  // The convention has it that a relative path counts for nothing.
  if (!folder.is_absolute()) {
    const std::filesystem::path home = variable("HOME");
    if (!home.is_absolute()) return {};
    folder = home / ".local" / "state";
  }
  folder /= "sir";
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  return failure ? std::filesystem::path() : folder / "history";
}

}  // namespace sir::cli
