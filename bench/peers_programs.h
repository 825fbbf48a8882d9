// How the two programs are called: `sir render`, and POV-Ray 3.7 on what `sir export --pov` writes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tracer/planes.h"
#include "tracer/scene.h"

namespace sir::bench {

/// A program and its arguments.
using Words = std::vector<std::string>;

/// Whether `povray` can be started.
bool has_povray();

/// `sir render ours` on one thread, planes and no PNG.
Words sir_words(const std::string& sir, ImageSize size, int depth, const std::string& precision);

/// Writes theirs.pov, as `sir export --pov --scale keep` would: scaled up POV-Ray takes every
/// object for infinite (a box of more than 2e10 is) and has no use for its boxes, which makes it
/// several times slower.
void write_pov(const std::filesystem::path& folder, const Scene& scene, ImageSize size, int depth);

/// POV-Ray on theirs.pov, with the arguments in that file's head; theirs.png or no image at all.
Words pov_words(ImageSize size, int threads, bool with_image);

/// CPU seconds, user's and system's, of the whole process. Throws std::runtime_error where it
/// fails.
double seconds_of(const Words& words);

}  // namespace sir::bench
