// What the bytes of a render depend on, as text (for thesis 3.3's SIR).
#pragma once

#include <string>

#include "tracer/render.h"
#include "tracer/scene.h"

namespace sir::cli {

/// One line for each: a name, a space and a value. Two renders with the same text trace
/// the same tiles to the same bytes: the program by its version and by a number that stands for
/// its file, the four files by such numbers of what they say, and all options that change pixels or
/// the order of the work. Not the number of threads, nor the folder. Options that antialiasing
/// does not use are left out.
std::string render_settings(const Scene& scene, const RenderOptions& options, bool progressive);

/// What differs, in words: "--depth is 6 and was 5; the scene's .CSG is another". Empty where
/// nothing does.
std::string settings_difference(const std::string& now, const std::string& before);

}  // namespace sir::cli
