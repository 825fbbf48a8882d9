#include "tracer/effect_set.h"

#include <array>
#include <unordered_set>

namespace sir {

const std::vector<std::string>& EffectSet::names() {
  static const std::vector<std::string> list{"highlight",  "shadow",  "filter", "reflection",
                                             "refraction", "texture", "bump",   "antialias"};
  return list;
}

bool* EffectSet::find(std::string_view name) {
  const std::array<bool*, 8> members{&highlight,  &shadow,  &filter, &reflection,
                                     &refraction, &texture, &bump,   &antialias};
  for (std::size_t i = 0; i < members.size(); ++i)
    if (names()[i] == name) return members[i];
  return nullptr;
}

EffectSet effects_called_for(const Scene& scene, const EffectSet& allowed, bool antialias_wanted) {
  EffectSet set = allowed;
  set.bump = false;  // nothing calls for it yet
  set.antialias = allowed.antialias && antialias_wanted;
  if (allowed.exhaustive) return set;
  std::unordered_set<std::int64_t> reached;
  for (const CsgNode& node : scene.tree.nodes)
    if (!node.composite)
      reached.insert(node.surfaces.begin(), node.surfaces.begin() + face_count(node.kind));

  bool shines = false, transmits = false, textured = false;
  for (const Surface& surface : scene.surfaces) {
    if (!reached.contains(surface.number)) continue;
    const bool chequer = surface.texture == TextureKind::chequer;
    shines = shines || surface.first.specular > 0 || (chequer && surface.second.specular > 0);
    transmits =
        transmits || surface.first.transmission > 0 || (chequer && surface.second.transmission > 0);
    textured = textured || chequer;
  }
  bool lit = false;
  for (const Light& light : scene.lighting.lights)
    lit = lit || light.intensity.x > 0 || light.intensity.y > 0 || light.intensity.z > 0;

  set.highlight = allowed.highlight && shines && lit;
  set.shadow = allowed.shadow && lit;
  set.filter = allowed.filter && transmits && lit;
  // Total reflection mirrors even what has no ks; it belongs to refraction.
  set.reflection = allowed.reflection && shines;
  set.refraction = allowed.refraction && transmits;
  set.texture = allowed.texture && textured;
  return set;
}

}  // namespace sir
