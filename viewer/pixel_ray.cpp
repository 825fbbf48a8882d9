#include "viewer/pixel_ray.h"

#include <array>
#include <utility>

namespace sir::viewer {
namespace {

/// No rays beyond the first: what they would see is not asked for.
TraceOptions first_ray_only() {
  TraceOptions options;
  options.depth_limit = 1;
  options.allowed_effects.shadow = false;
  return options;
}

}  // namespace

PixelRay::PixelRay(std::shared_ptr<const Scene> scene, ImageSize size)
    : scene_(std::move(scene)),
      size_(size),
      model_(std::make_unique<Model<double>>(*scene_, first_ray_only().possible_effects())),
      tracer_(*model_, first_ray_only()) {
  const auto& nodes = scene_->tree.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes_.emplace(nodes[i].number, i);
}

RayFind PixelRay::find(int column, int row) {
  TraceLog log;
  tracer_.radiance(model_->camera.primary_ray(column, row, size_), &log);
  const TraceNode& first = log.front();
  if (!first.hit) return {};
  const CsgNode& node = scene_->tree.nodes[nodes_.at(first.node)];
  const Surface& surface = scene_->surfaces[first.surface];
  return {true,       first.node,     node.name,    node.kind,
          first.face, surface.number, surface.name, first.t};
}

std::string face_name(PrimitiveKind kind, int face) {
  const auto number = static_cast<std::size_t>(face);
  switch (kind) {
    case PrimitiveKind::cube: {
      constexpr std::array kNames{"X=0", "X=1", "Y=0", "Y=1", "Z=0", "Z=1"};
      return kNames.at(number);
    }
    case PrimitiveKind::cone: return std::array{"side", "base"}.at(number);
    case PrimitiveKind::cylinder: return std::array{"Y=0", "Y=1", "side"}.at(number);
    case PrimitiveKind::sphere: break;
  }
  return {};
}

}  // namespace sir::viewer
