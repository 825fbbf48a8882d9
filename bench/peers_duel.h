// `sir` against POV-Ray 3.7: the same scene and pixels, one thread each, no PNG of either.
#pragma once

#include <filesystem>
#include <string>

#include "bench/peers_table.h"
#include "tracer/planes.h"
#include "tracer/scene.h"

namespace sir::bench {

/// One scene rendered by both.
struct Contest {
  std::string name;
  Scene ours;
  Scene theirs;  ///< the same solid, perhaps written in another way
  ImageSize size;
  int depth = 1;
  Demand in_double, in_float;
};

/// What the programs need to run.
struct Arena {
  std::string sir;               ///< the program
  std::filesystem::path folder;  ///< the working folder, for the scenes' files
  bool povray = false;           ///< it is there
  int rounds = 5;
};

/// Compares the images first; where they are not the same picture nothing is timed, and the
/// answer is false. Then double, float and POV-Ray take turns. Times are the CPU's, user's and
/// system's, of the whole process, parsing included. Without povray only ours are told.
/// Throws std::runtime_error where a program fails.
bool run_contest(const Contest& contest, const Arena& arena, SpeedTable& table);

/// A frame of 500x500 where POV-Ray is too slow for one: its time is its start and parsing, and as
/// many pixels as there are at what the pixels of `contest`'s small image cost on the average.
/// Ours is measured, in double; `contest.in_double` is demanded. Without povray nothing is told.
void run_extrapolated(const Contest& contest, const Arena& arena, SpeedTable& table);

/// The most memory that `sir render` took, in MB of 2^20 bytes.
double peak_megabytes(const Scene& scene, ImageSize size, const Arena& arena);

}  // namespace sir::bench
