// `sir probe`: rays on standard input, their boundaries on standard output
// (RAY-TRACING, thesis 2.3.6).
#pragma once

#include <filesystem>

#include "cli/session.h"
#include "tracer/render.h"

namespace sir::cli {

struct ProbeCommand {
  std::filesystem::path base;
  Precision precision = Precision::double_;
  Engine engine = Engine::gates;
};

/// One JSON line for each line `ox oy oz dx dy dz`; a bad line gives an error
/// object in its place and exit code 1 at the end. Blank lines are passed over.
int run_probe(const ProbeCommand& command, int descriptor, const Session& session);

}  // namespace sir::cli
