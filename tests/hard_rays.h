// Rays on which ray tracers of CSG go wrong, class by class. The list is the
// same on every machine: integers from std::mt19937_64, and sums, products and
// quotients of doubles, nothing from the mathematical library but sqrt.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tracer/scene.h"

namespace sir::test {

struct HardRay {
  std::shared_ptr<const Scene> scene;
  glm::dvec3 origin{0}, direction{0, 0, 1};
};

class Dice;

/// One kind of difficulty, with 60 rays or more.
struct HardClass {
  std::string name;
  std::vector<HardRay> (*make)(Dice& dice);

  std::uint64_t seed() const;  ///< from the name: classes do not move one another
  std::vector<HardRay> rays() const;
};

/// Every class, in the order of the documentation's table.
const std::vector<HardClass>& hard_classes();

/// By idea; hard_classes() is their sum.
std::vector<HardClass> hard_classes_distance();    ///< far, tiny, huge quadrics
std::vector<HardClass> hard_classes_grazing();     ///< near tangency, and at it
std::vector<HardClass> hard_classes_cone();        ///< apex, generators, second nappe
std::vector<HardClass> hard_classes_flat();        ///< edges, corners, parallels, in faces
std::vector<HardClass> hard_classes_coincident();  ///< coincident, same, touching, thin
std::vector<HardClass> hard_classes_start();       ///< rays that begin on or in solids
std::vector<HardClass> hard_classes_matrix();      ///< anisotropy, shear, condition, mirrors
std::vector<HardClass> hard_classes_scale();       ///< moved and scaled scenes, long directions
std::vector<HardClass> hard_classes_tree();        ///< chains and random compositions

}  // namespace sir::test
