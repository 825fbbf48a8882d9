// Scenes for the comparison with POV-Ray, each about one thing.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tracer/scene.h"

namespace sir::test {

struct PovCase {
  std::string name;
  Scene scene;
  int depth_limit = 5;
};

/// For the test's report.
inline void PrintTo(const PovCase& given, std::ostream* out) { *out << given.name; }

/// Every effect on its own and some together. No faces coincide, and where
/// there is glass in which total reflection can occur, ks + kt = 1: only then
/// POV-Ray weighs the mirrored ray as SIR does.
std::vector<PovCase> pov_cases();

/// Random scenes of which something is seen; total reflection weighs as it comes.
std::vector<PovCase> pov_random_cases();

}  // namespace sir::test
