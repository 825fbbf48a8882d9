// sir replay: what was done at the MA120's registers, done again (our model; the thesis has no
// such thing).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "cli/add_option.h"

namespace sir::cli {

struct ReplayOptions {
  std::filesystem::path trace;               ///< as eltek/trace_text.h reads it
  std::optional<std::filesystem::path> png;  ///< write the frame
  std::optional<std::uint64_t> steps;        ///< play no more records than these
  bool json = false;
  bool window = false;  ///< step through it in the viewer
};

/// Plays the trace and prints what it held: records, accesses by register, the beam's place, and
/// the hash of the frame as it would be if nothing more were written. Writes that frame: as
/// indexed PNG where one palette was there for all of it, else as RGB. In a window a person steps
/// through it. Returns an exit code.
/// Throws FileError, in the end also where a read gave something else than the trace says.
int run_replay(const ReplayOptions& options, const Session& session);

/// Adds the subcommand, which leaves its work in `action`.
void add_replay(CLI::App& app, Action& action);

}  // namespace sir::cli
