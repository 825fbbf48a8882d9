// Scenes made by the number of their primitives, for what grows with it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tracer/scene.h"

namespace sir::bench {

/// What may be chosen about a made scene.
struct MadeScene {
  /// How a cube is taken away from the whole. `distributed`: from each solid near it, as a person
  /// would write it who knows that A u B - C = (A - C) u (B - C); the same image.
  enum class Cut : std::uint8_t { none, root, distributed };

  int primitives = 300;  ///< at least 1; the cutting cube is not among them
  bool chain = false;    ///< a left-deep chain of unions in random order; else a balanced tree,
                         ///< halved by place
  bool spheres = false;  ///< a union of spheres and nothing else
  Cut cut = Cut::none;

  /// mixed-300, chain-3000, cut-30000, spheres-300 and so on.
  std::string name() const;
};

/// N primitives of all four kinds in the cube [-1,1]^3, turned at random: 35 % of them solids by
/// themselves, the others in A - B, A - B - C and A n B. Sizes go with N^(-1/3), so that a ray
/// meets about as many whatever N. Matt surfaces, one light, the whole seen from a corner; meant
/// for 500x500. The same numbers give the same scene everywhere, bit for bit but for the
/// rounding of the mathematical library.
Scene made_scene(const MadeScene& wanted);

/// The sizes of the suite.
inline constexpr int kSizes[] = {300, 3'000, 30'000};

/// Everything that is measured: of each size balanced, chain, cut, distributed and spheres.
std::vector<MadeScene> made_suite(std::span<const int> sizes = kSizes);

}  // namespace sir::bench
