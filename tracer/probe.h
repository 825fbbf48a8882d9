// Where given rays cross the solid: RAY-TRACING (thesis 2.3.6) without shading.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "tracer/classify.h"
#include "tracer/render.h"
#include "tracer/scene.h"

namespace sir {

/// A boundary as the outside world names it.
struct ProbeHit {
  double t = 0;  ///< in units of the direction as given
  bool entering = false;
  std::int64_t node = 0;  ///< numbers as in the files
  int face = 0;
  std::int64_t surface = 0;
};

/// A solid that can be asked about many rays; the scalar type is chosen once.
class Prober {
 public:
  virtual ~Prober() = default;

  /// All boundaries at t >= 0, in order, of the ray origin + t direction in
  /// SC_CENA. The direction is finite and not zero, of any length.
  virtual const std::vector<ProbeHit>& hits(const glm::dvec3& origin,
                                            const glm::dvec3& direction) = 0;
};

std::unique_ptr<Prober> make_prober(const Scene& scene, Precision precision,
                                    Engine engine = Engine::gates);

}  // namespace sir
