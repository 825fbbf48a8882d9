#include "fuzz/same.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace sir::fuzz {
namespace {

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same(const glm::dvec3& a, const glm::dvec3& b) {
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

bool same(const Placement& a, const Placement& b) {
  for (int line = 0; line < 3; ++line)
    if (!same(a.linear[line], b.linear[line])) return false;
  return same(a.translation, b.translation);
}

bool same(const CsgNode& a, const CsgNode& b) {
  if (a.number != b.number || a.name != b.name || a.composite != b.composite) return false;
  if (a.composite) return a.operation == b.operation && a.left == b.left && a.right == b.right;
  return a.kind == b.kind &&
         std::equal(a.surfaces.begin(), a.surfaces.begin() + face_count(a.kind),
                    b.surfaces.begin()) &&
         a.surface_per_face == b.surface_per_face && same(a.placement, b.placement);
}

bool same(const Coefficients& a, const Coefficients& b) {
  return same(a.ambient, b.ambient) && same(a.diffuse, b.diffuse) && same(a.specular, b.specular) &&
         same(a.exponent, b.exponent) && same(a.transmission, b.transmission) &&
         same(a.index, b.index);
}

bool same(const Surface& a, const Surface& b) {
  return a.number == b.number && a.name == b.name && a.texture == b.texture &&
         same(a.first, b.first) && same(a.second, b.second) && a.cells_u == b.cells_u &&
         a.cells_v == b.cells_v;
}

bool same(const Light& a, const Light& b) {
  return same(a.position, b.position) && same(a.intensity, b.intensity);
}

template <typename Item>
bool all_same(const std::vector<Item>& a, const std::vector<Item>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Item& x, const Item& y) { return same(x, y); });
}

}  // namespace

bool same(const CsgTree& a, const CsgTree& b) {
  return a.root == b.root && all_same(a.nodes, b.nodes);
}

bool same(const CameraFile& a, const CameraFile& b) {
  return same(a.window.x, b.window.x) && same(a.window.y, b.window.y) && same(a.target, b.target) &&
         same(a.normal, b.normal) && same(a.distance, b.distance) && same(a.up, b.up) &&
         a.parallel == b.parallel && same(a.focal, b.focal) && a.focal_given == b.focal_given;
}

bool same(const Lighting& a, const Lighting& b) {
  return same(a.background, b.background) && same(a.ambient, b.ambient) &&
         all_same(a.lights, b.lights);
}

bool same(const std::vector<Surface>& a, const std::vector<Surface>& b) { return all_same(a, b); }

}  // namespace sir::fuzz
