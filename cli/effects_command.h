// `sir effects`: what a scene calls for, why, and what that costs and changes.
#pragma once

#include <filesystem>

#include "cli/session.h"
#include "tracer/render.h"

namespace sir::cli {

struct EffectsCommand {
  std::filesystem::path base;
  RenderOptions options;
  int repeats = 5;
  bool json = false;
};

/// Prints a table of the effects, or JSON. Returns an exit code; throws FileError.
int run_effects(const EffectsCommand& command, const Session& session);

}  // namespace sir::cli
