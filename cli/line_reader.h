// Lines from a person at a terminal (the thesis has none).
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "modeler/completion.h"

namespace sir::cli {

/// Asks for lines.
class LineReader {
 public:
  virtual ~LineReader() = default;
  /// The next line without its end; none at the end of input (Ctrl-D) and where a signal came.
  virtual std::optional<std::string> read() = 0;
};

struct LineOptions {
  std::string prompt;
  std::function<modeler::Completion(std::string_view line)> complete;  ///< of the line up to here
  std::filesystem::path history;  ///< kept from session to session; empty: nowhere
};

/// With editing, history and completion (libedit); null where this build or the terminal is not fit
/// for it. Ctrl-C empties the line.
std::unique_ptr<LineReader> make_editing_reader(const LineOptions& options);

/// Without any of it.
std::unique_ptr<LineReader> make_plain_reader(const LineOptions& options);

/// $XDG_STATE_HOME/sir/history, or ~/.local/state/sir/history; its folder is made. Empty where
/// there is no home.
std::filesystem::path history_file();

}  // namespace sir::cli
