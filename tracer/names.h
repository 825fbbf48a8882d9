// What solids' kinds, faces and operations are called in messages: tables 2.1 and 2.3 of the
// thesis, in English.
#pragma once

#include <string_view>

#include "tracer/scene.h"

namespace sir {

/// "cube", "sphere", "cone", "cylinder"; "union", "difference", "intersection".
std::string_view name_of(PrimitiveKind kind);
std::string_view name_of(Operation operation);

/// A face by the equation or the part that it is: "X=0", "side", "base"; the one of a sphere is
/// "surface". `face` as in the .CSG.
std::string_view face_name(PrimitiveKind kind, int face);

}  // namespace sir
