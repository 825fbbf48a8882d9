// What `sir probe` must answer, worked out exactly from the contract
// (docs/scene-format.md) and from nothing else: the tracer's formulas, its
// flattened composition and its order of evaluation have no part in it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/exact_solids.h"
#include "tracer/scene.h"

namespace sir::test {

/// A boundary of the combined solid.
struct ExactHit {
  Real t;  ///< in units of the direction, good to 98 digits
  bool entering = false;
  std::int64_t node = 0;
  int face = 0;
  std::size_t node_index = 0;  ///< into CsgTree::nodes
  bool own_face = true;        ///< t is this face's own crossing, not that of another one
                               ///< within 32 ulp which is farther inside
  Real slack;                  ///< how far the roundings that were allowed may move t
};

struct ExactAnswer {
  std::vector<ExactHit> hits;  ///< at t >= 0, in order
  bool definite = true;        ///< false: a rounding could change the list
};

/// What arithmetic the answer is for.
struct Allowance {
  int digits = 53;  ///< of the ulp in the rule of 32 ulp: 53 double, 24 float
  /// Roundings to that many digits, of each input, that the answer must stand:
  /// where they could change it, it is indefinite. 0: the inputs are exact.
  double roundings = 0;
};

class ExactOracle {
 public:
  explicit ExactOracle(const Scene& scene);

  ExactAnswer answer(const glm::dvec3& origin, const glm::dvec3& direction,
                     const Allowance& allowance = {}) const;

  /// Checks the sweep against points: the middle of every stretch between
  /// neighbouring events is put to every primitive's inequalities, and the tree
  /// evaluated on that. At most `stretches` of them, spread evenly. Empty where
  /// all agree, else what does not.
  std::string disagreement(const glm::dvec3& origin, const glm::dvec3& direction, int digits,
                           std::size_t stretches = 64) const;

  /// How many roundings of each input (ray and matrix entries, 2^-53 each) bring
  /// the face to t exactly: backward error, to first order.
  struct Backward {
    double roundings;     ///< that explain t
    double one_rounding;  ///< how far one rounding of every input moves the root
  };
  Backward backward_error(std::size_t node_index, int face, const glm::dvec3& origin,
                          const glm::dvec3& direction, double t) const;

 private:
  struct Leaf {
    std::size_t node;
    ExactPlacement placement;
  };
  struct End {
    Real t, slack;
    int face = 0;
    bool own_face = true;
    std::size_t cluster = 0;
  };
  struct Crossed {
    std::size_t leaf;
    End enter, leave;
  };
  struct Sweep {
    std::vector<Crossed> crossed;
    std::vector<Real> first, last;  // t of each cluster's first and last end
    bool definite = true;
  };
  using States = std::vector<char>;  // of each node: is this place inside it?

  Sweep sweep(const glm::dvec3& origin, const glm::dvec3& direction,
              const Allowance& allowance) const;
  bool cross(const Leaf& leaf, const HomogeneousRay& ray, double margin, const Allowance& allowance,
             Crossed& crossed, bool& definite) const;
  States before_cluster(const Sweep& sweep, std::size_t cluster) const;
  void combine(States& states) const;
  ExactHit named(const Sweep& sweep, std::size_t cluster, const States& before,
                 const States& after) const;
  double margin_of(const Leaf& leaf, const glm::dvec3& origin, const Allowance& allowance) const;

  Scene scene_;
  std::vector<Leaf> leaves_;
  std::vector<std::size_t> upwards_;  // all nodes, children before parents
};

}  // namespace sir::test
