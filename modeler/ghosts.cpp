#include "modeler/ghosts.h"

#include <set>
#include <utility>

#include "modeler/guides.h"
#include "tracer/sample_progressive.h"

namespace sir::modeler {
namespace {

constexpr double kShare = 0.4;
constexpr Rgb8 kTint{255, 170, 90};

std::int64_t free_number(const Scene& scene) {
  std::set<std::int64_t> taken;
  for (const Surface& surface : scene.surfaces) taken.insert(surface.number);
  std::int64_t number = 0;
  while (taken.contains(number)) ++number;
  return number;
}

}  // namespace

bool make_ghost_scene(const Scene& scene, Scene& ghosts) {
  ghosts.tree = scene.tree;
  ghosts.camera = scene.camera;
  const std::int64_t number = free_number(scene);
  bool any = false;
  struct Open {
    std::size_t node;
    bool ghost;
  };
  std::vector<Open> open{{ghosts.tree.root, false}};
  while (!open.empty()) {
    const auto [index, ghost] = open.back();
    open.pop_back();
    CsgNode& node = ghosts.tree.nodes[index];
    if (!node.composite) {
      if (ghost) node.surfaces.fill(number);
      continue;
    }
    // Within what is taken away, differences stay: it is the whole of it that is shown.
    const bool takes = !ghost && node.operation == Operation::difference;
    if (takes) node.operation = Operation::union_of;
    any = any || takes;
    open.push_back({node.left, ghost});
    open.push_back({node.right, ghost || takes});
  }
  if (!any) return false;
  ghosts.surfaces = scene.surfaces;
  for (Surface& surface : ghosts.surfaces) {
    surface.texture = TextureKind::plain;
    surface.first = Coefficients{};
  }
  Surface ghost;
  ghost.number = number;
  ghost.first.ambient = glm::dvec3(0.35);  // never black
  ghost.first.diffuse = glm::dvec3(0.65);
  ghosts.surfaces.push_back(ghost);
  ghosts.lighting = Lighting{};
  ghosts.lighting.ambient = glm::dvec3(1);
  for (const Light& light : scene.lighting.lights) {
    ghosts.lighting.lights.push_back({light.position, glm::dvec3(1)});
    break;  // one shows the form
  }
  return true;
}

GhostLayer ghost_layer(const Scene& ghosts, ImageSize size, int threads, int block,
                       const std::stop_token& stop) {
  RenderOptions options;
  options.size = size;
  options.threads = threads;
  options.trace = TraceOptions::primary_rays_only();
  RenderResult seen = block > 1 ? render_preview(ghosts, options, block, true, stop)
                                : render(ghosts, options, {}, stop);
  if (!seen.complete) return {};
  return std::move(seen.planes.channel[0]);
}

void blend(const GhostLayer& ghosts, Planes& picture) {
  for (std::size_t pixel = 0; pixel < ghosts.size(); ++pixel) {
    if (ghosts[pixel] == 0) continue;
    const Rgb8 seen = mixed({}, kTint, ghosts[pixel] / 255.0);
    picture.set(pixel, mixed(picture.at(pixel), seen, kShare));
  }
}

}  // namespace sir::modeler
