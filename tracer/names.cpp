#include "tracer/names.h"

namespace sir {

std::string_view name_of(PrimitiveKind kind) {
  constexpr std::string_view kNames[] = {"cube", "sphere", "cone", "cylinder"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string_view name_of(Operation operation) {
  constexpr std::string_view kNames[] = {"union", "difference", "intersection"};
  return kNames[static_cast<std::size_t>(operation)];
}

std::string_view face_name(PrimitiveKind kind, int face) {
  constexpr std::string_view kCube[] = {"X=0", "X=1", "Y=0", "Y=1", "Z=0", "Z=1"};
  constexpr std::string_view kCone[] = {"side", "base"};
  constexpr std::string_view kCylinder[] = {"Y=0", "Y=1", "side"};
  switch (kind) {
    case PrimitiveKind::cube: return kCube[face];
    case PrimitiveKind::sphere: return "surface";
    case PrimitiveKind::cone: return kCone[face];
    case PrimitiveKind::cylinder: return kCylinder[face];
  }
  return "";
}

}  // namespace sir
