#include "tracer/probe.h"

#include <cmath>

#include "tracer/numeric.h"
#include "tracer/recentre.h"

namespace sir {
namespace {

template <typename T>
class ProberIn : public Prober {
 public:
  ProberIn(const Scene& scene, const glm::dvec3& offset, Engine engine)
      : offset_(offset),
        solid_(build_solid<T>(Recentred(scene, offset))),
        classifier_(solid_, engine) {
    for (const Surface& surface : scene.surfaces) surface_numbers_.push_back(surface.number);
  }

  const std::vector<ProbeHit>& hits(const glm::dvec3& origin,
                                    const glm::dvec3& direction) override {
    // Traced with a direction near 1, so that lengths of 1e-150 and 1e150
    // neither underflow nor overflow; a power of two changes no digit of t.
    const double largest =
        std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    const int exponent = -std::ilogb(largest);
    hits_.clear();
    classifier_.begin(
        {{glm::vec<3, T>(origin - offset_)}, {glm::vec<3, T>(scaled_near_one(direction))}});
    Boundary<T> boundary;
    while (classifier_.next(boundary)) {
      const Leaf<T>& leaf = solid_.leaves[boundary.leaf];
      hits_.push_back({std::ldexp(double(boundary.t), exponent), boundary.entering, leaf.node,
                       boundary.face, surface_numbers_[leaf.surfaces[boundary.face]]});
    }
    return hits_;
  }

 private:
  glm::dvec3 offset_;
  Solid<T> solid_;
  Classifier<T> classifier_;
  std::vector<std::int64_t> surface_numbers_;
  std::vector<ProbeHit> hits_;
};

}  // namespace

std::unique_ptr<Prober> make_prober(const Scene& scene, Precision precision, Engine engine) {
  const glm::dvec3 offset = offset_for(scene, precision);
  if (precision == Precision::float_)
    return std::make_unique<ProberIn<float>>(scene, offset, engine);
  if (precision == Precision::long_double)
    return std::make_unique<ProberIn<long double>>(scene, offset, engine);
  return std::make_unique<ProberIn<double>>(scene, offset, engine);
}

}  // namespace sir
