#include "viewer/pixel_ray.h"

#include <utility>

namespace sir::viewer {
namespace {

const TraceOptions kPrimary = TraceOptions::primary_rays_only();

}  // namespace

PixelRay::PixelRay(std::shared_ptr<const Scene> scene, ImageSize size)
    : scene_(std::move(scene)),
      size_(size),
      model_(std::make_unique<Model<double>>(*scene_, kPrimary.possible_effects())),
      tracer_(*model_, kPrimary) {
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

}  // namespace sir::viewer
