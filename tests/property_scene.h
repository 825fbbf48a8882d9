// Random solids, rays and materials for the property tests.
#pragma once

#include <cstdint>
#include <ostream>
#include <random>
#include <string>

#include "tests/scene_builder.h"

namespace sir::test {

/// What is hard about a random solid.
enum class Regime : std::uint8_t {
  generic,  ///< turned and scaled primitives of size about 1
  aligned,  ///< on a grid of halves, so that faces, edges and axes coincide often
  sizes,    ///< from 1e-6 to 1e6
  thin,     ///< flattened along one axis, down to 1e-9
  sheared   ///< condition numbers up to 1e4, and mirrored
};
inline constexpr Regime kRegimes[] = {Regime::generic, Regime::aligned, Regime::sizes, Regime::thin,
                                      Regime::sheared};
const char* name_of(Regime regime);
inline void PrintTo(Regime regime, std::ostream* out) { *out << name_of(regime); }

/// A source of numbers that can be named by its seed.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  std::mt19937_64& engine() { return engine_; }
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  bool once_in(int count) { return below(count) == 0; }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  glm::dvec3 in_cube(double half) {
    const double x = between(-half, half), y = between(-half, half);
    return {x, y, between(-half, half)};
  }
  glm::dvec3 direction();  ///< unit, any

 private:
  std::mt19937_64 engine_;
};

/// Adds a random tree of `leaves` primitives to what is being built. Node
/// numbers of leaves are distinct over all of it, and in no order.
SceneBuilder::Id add_random_solid(SceneBuilder& build, Random& random, Regime regime, int leaves);

/// Adds a copy of the tree below `id`; its leaves keep their node numbers.
SceneBuilder::Id add_copy(SceneBuilder& build, SceneBuilder::Id id);

/// Camera, lights and surfaces that any of the solids can be seen with.
void light_and_aim(Scene& scene, Random& random);

/// A ray in SC_CENA. Its numbers are floats, so that both precisions trace the
/// same line.
struct TestRay {
  glm::dvec3 origin, direction;
};

/// With 17 digits, to be traced again.
std::string describe(const TestRay& ray);

/// A ray that is likely to meet the solid: aimed at a random leaf from near or
/// far, from inside too; in Regime::aligned often along the grid.
TestRay random_ray(const Scene& scene, Random& random, Regime regime);

}  // namespace sir::test
