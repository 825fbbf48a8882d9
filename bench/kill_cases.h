// The commands that are killed: render, lut, show and model, each with other bytes than before.
#pragma once

#include <filesystem>
#include <vector>

#include "bench/kill_trial.h"
#include "tracer/planes.h"

namespace sir::bench {

/// Writes what they read into `folder`, by `program` in part, for images of `size`: a scene that is
/// traced quickly, so that writing is a large part of the time.
std::vector<KillCase> kill_cases(const std::string& program, const std::filesystem::path& folder,
                                 ImageSize size);

}  // namespace sir::bench
