#include "tracer/effect_causes.h"

#include <unordered_map>

namespace sir {
namespace {

// What one surface may ask for.
struct Traits {
  bool shines = false, transmits = false, textured = false, brightens = false;

  Traits& operator|=(const Traits& other) {
    shines = shines || other.shines;
    transmits = transmits || other.transmits;
    textured = textured || other.textured;
    brightens = brightens || other.brightens;
    return *this;
  }
};

Traits traits_of(const Coefficients& k) {
  const bool diffuse = k.diffuse.r > 0 || k.diffuse.g > 0 || k.diffuse.b > 0;
  return {k.specular > 0, k.transmission > 0, false, diffuse || k.specular > 0};
}

bool same(const Coefficients& a, const Coefficients& b) {
  return a.ambient == b.ambient && a.diffuse == b.diffuse && a.specular == b.specular &&
         a.exponent == b.exponent && a.transmission == b.transmission && a.index == b.index;
}

Traits traits_of(const Surface& surface) {
  Traits traits = traits_of(surface.first);
  if (surface.texture != TextureKind::chequer || same(surface.first, surface.second)) return traits;
  traits |= traits_of(surface.second);
  traits.textured = true;
  return traits;
}

std::vector<bool> reached_by_root(const CsgTree& tree) {
  std::vector<bool> reached(tree.nodes.size());
  std::vector<std::size_t> open{tree.root};
  while (!open.empty()) {
    const std::size_t index = open.back();
    open.pop_back();
    reached[index] = true;
    const CsgNode& node = tree.nodes[index];
    if (!node.composite) continue;
    open.push_back(node.left);
    open.push_back(node.right);
  }
  return reached;
}

}  // namespace

EffectCauses effect_causes(const Scene& scene) {
  std::unordered_map<std::int64_t, Traits> of_surface;
  for (const Surface& surface : scene.surfaces)
    of_surface.emplace(surface.number, traits_of(surface));
  std::vector<std::size_t> lights;
  for (std::size_t i = 0; i < scene.lighting.lights.size(); ++i) {
    const glm::dvec3& intensity = scene.lighting.lights[i].intensity;
    if (intensity.r > 0 || intensity.g > 0 || intensity.b > 0) lights.push_back(i);
  }

  EffectCauses causes;
  const std::vector<bool> reached = reached_by_root(scene.tree);
  for (std::size_t i = 0; i < scene.tree.nodes.size(); ++i) {
    const CsgNode& node = scene.tree.nodes[i];
    if (!reached[i] || node.composite) continue;
    Traits traits = of_surface[node.surfaces[0]];
    for (std::size_t face = 1; face < static_cast<std::size_t>(face_count(node.kind)); ++face)
      if (node.surfaces[face] != node.surfaces[0]) traits |= of_surface[node.surfaces[face]];
    if (traits.shines) causes.reflection.nodes.push_back(i);
    if (traits.transmits) causes.refraction.nodes.push_back(i);
    if (traits.textured) causes.texture.nodes.push_back(i);
    if (traits.brightens) causes.shadow.nodes.push_back(i);
  }
  causes.highlight.nodes = causes.reflection.nodes;
  if (causes.shadow.any()) causes.filter.nodes = causes.refraction.nodes;
  for (EffectCause* by_light : {&causes.highlight, &causes.shadow, &causes.filter}) {
    if (!by_light->nodes.empty()) by_light->lights = lights;
    if (lights.empty()) by_light->nodes.clear();
  }
  return causes;
}

}  // namespace sir
