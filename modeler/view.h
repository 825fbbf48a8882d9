// How a solid is looked at: the camera and the bounds in SC_OBS (percorre_transformando_sólido,
// thesis 3.2.2.9).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/node.h"
#include "tracer/planes.h"
#include "tracer/scene.h"
#include "tracer/tiles.h"

namespace sir::modeler {

/// Whether the box holds a point and is not so large that the camera's numbers would not be finite.
bool can_be_framed(const Box& bounds);

/// A camera that has the whole box in its window, 5 % of it free on each side: in perspective, from
/// the front, a little from the right and from above, along (-0.5, -0.5, -1). `aspect`: width over
/// height. The box can_be_framed().
CameraFile framing(const Box& bounds, double aspect);

/// ENVOLTORIO in SC_OBS of every node, in the order of preorder(): of primitives tight, of
/// composites by their operation.
std::vector<Box> bounds_in_obs(const Node& tree, const CameraFile& camera);

/// The pixels through which rays can meet what is in this box in SC_OBS; all of them where part of
/// it is beside or behind the eye.
Region pixels_of(const Box& in_obs, const CameraFile& camera, ImageSize size);

/// Looks where nothing is said of them: each surface number has a hue of its own, matt with a
/// little gloss, and one light stands over the observer's left shoulder.
Surface made_up_surface(std::int64_t number);
Lighting made_up_lighting(const CameraFile& camera);

/// A scene of this solid alone, its surfaces and light made up.
Scene scene_of(const Node& tree, const CameraFile& camera);

/// Gives a scene the light, where there is one, and to its surfaces what is described of them.
void dress(Scene& scene, const std::optional<Lighting>& lighting,
           const std::vector<Surface>& described);

}  // namespace sir::modeler
