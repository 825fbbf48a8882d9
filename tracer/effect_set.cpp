#include "tracer/effect_set.h"

#include <array>

#include "tracer/effect_causes.h"

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
  const EffectCauses causes = effect_causes(scene);
  set.highlight = allowed.highlight && causes.highlight.any();
  set.shadow = allowed.shadow && causes.shadow.any();
  set.filter = allowed.filter && set.shadow && causes.filter.any();
  // Total reflection mirrors even what has no ks; it belongs to refraction.
  set.reflection = allowed.reflection && causes.reflection.any();
  set.refraction = allowed.refraction && causes.refraction.any();
  set.texture = allowed.texture && causes.texture.any();
  return set;
}

}  // namespace sir
