#include "modeler/pick.h"

#include <utility>

#include "modeler/view.h"

namespace sir::modeler {
namespace {

const TraceOptions kPrimary = TraceOptions::primary_rays_only();

}  // namespace

Picker::Picker(NodePtr solid, const CameraFile& camera, ImageSize size)
    : solid_(std::move(solid)),
      size_(size),
      scene_(scene_of(*solid_, camera)),
      nodes_(preorder(*solid_)),
      model_(std::make_unique<Model<double>>(scene_, kPrimary.possible_effects())),
      tracer_(*model_, kPrimary) {
  // Whatever order the scene's nodes are in, walked from the root they come as ours do.
  std::vector<std::size_t> open{scene_.tree.root};
  for (std::size_t place = 0; !open.empty(); ++place) {
    const CsgNode& node = scene_.tree.nodes[open.back()];
    open.pop_back();
    places_.emplace(node.number, place);
    if (!node.composite) continue;
    open.push_back(node.right);
    open.push_back(node.left);
  }
}

std::optional<Pick> Picker::at(int column, int row) {
  TraceLog log;
  const auto ray = model_->camera.primary_ray(column, row, size_);
  tracer_.radiance(ray, &log);
  const TraceNode& first = log.front();
  if (!first.hit) return std::nullopt;
  const std::size_t place = places_.at(first.node);
  return Pick{nodes_[place], place,
              first.face,    scene_.surfaces[first.surface].number,
              first.t,       ray.origin.v + first.t * ray.direction.v};
}

}  // namespace sir::modeler
