// Surfaces as POV-Ray textures (thesis 2.4.3, 2.4.4).
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tracer/scene.h"

namespace sir {

/// How a face reads its (u,v) from SC_LOCAL; see texture_uv().
enum class PovUv : std::uint8_t { zy, xz, xy, ball, side, cap };
PovUv pov_uv(PrimitiveKind kind, int face);

/// Name of a surface's texture; that of a chequered one depends on how the face
/// reads (u,v).
std::string pov_texture_name(const Surface& surface, PovUv uv);

/// The functions of x, y, z in SC_LOCAL that the textures are made of: u and v,
/// and the face of a primitive that a point is nearest to, in eighths.
std::string pov_functions();

/// The declarations of a surface's textures for the (u,v) in `uses`.
std::string pov_textures(const Surface& surface, const glm::dvec3& ambient,
                         const std::set<PovUv>& uses);

/// What stands in a primitive to give it its surfaces, one or one per face.
std::string pov_texture_of(const CsgNode& primitive, const std::vector<const Surface*>& of_face);

}  // namespace sir
