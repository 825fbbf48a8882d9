#include "modeler/looks.h"

namespace sir::modeler {
namespace {

// Does a change, from what was before to what is after; the other way round with the two swapped.
struct Doing {
  Looks& looks;
  bool back;

  template <typename T>
  const T& wanted(const T& before, const T& after) const {
    return back ? before : after;
  }

  void operator()(const LightingChange& change) const {
    looks.lighting = wanted(change.before, change.after);
  }
  void operator()(const ShadeChange& change) const {
    (*looks.lighting).*change.shade = wanted(change.before, change.after);
  }
  void operator()(const LightChange& change) const {
    std::vector<Light>& lights = looks.lighting->lights;
    const auto at = lights.begin() + static_cast<std::ptrdiff_t>(change.index);
    const std::optional<Light>& light = wanted(change.before, change.after);
    if (!wanted(change.after, change.before)) lights.insert(at, *light);
    else if (light) *at = *light;
    else lights.erase(at);
  }
  void operator()(const SurfaceChange& change) const {
    const std::optional<Surface>& surface = wanted(change.before, change.after);
    if (surface) looks.surfaces.insert_or_assign(change.number, *surface);
    else looks.surfaces.erase(change.number);
  }
};

}  // namespace

std::vector<Surface> Looks::surface_list() const {
  std::vector<Surface> list;
  for (const auto& [number, surface] : surfaces) list.push_back(surface);
  return list;
}

void apply(const LookChanges& changes, Looks& looks) {
  for (const LookChange& change : changes) std::visit(Doing{looks, false}, change);
}

void revert(const LookChanges& changes, Looks& looks) {
  for (std::size_t i = changes.size(); i-- > 0;) std::visit(Doing{looks, true}, changes[i]);
}

}  // namespace sir::modeler
