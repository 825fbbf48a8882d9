#include "interchange/pov_surface.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "interchange/pov_view.h"
#include "tracer/text_file.h"

namespace sir {
namespace {

// Parts of a layered texture add up, each dimmed by the transparency of those
// above it: ambient light and highlights, diffuse light, and what shines
// through are a layer each, because a layer has but one colour. A layer weighs
// its colour by 1 - transmit, and POV-Ray takes any number for both: the two
// upper layers transmit half, and twice and four times as much below makes up
// for it. (A single layer could not even be written where kt = 1.)
std::string layers(const Coefficients& k, const glm::dvec3& ambient) {
  constexpr const char* kLayer = "  texture {{ pigment {{ rgbt <{:.9g},{:.9g},{:.9g},{:.9g}> }}";
  const auto layer = [&](const glm::dvec3& c, double transmit) {
    return fmt::format(fmt::runtime(kLayer), c.r, c.g, c.b, transmit);
  };
  const bool opaque = !(k.transmission > 0);
  std::string text;
  if (!opaque) text += layer(glm::dvec3(0), 4 * k.transmission) + " }\n";
  text += opaque ? layer(2.0 * k.diffuse, 0) : layer(4.0 * k.diffuse, 0.5);
  text += " finish { diffuse 1 } }\n";
  text += layer(2.0 * ambient * k.ambient, 0.5) + " finish { emission 1";
  if (k.specular > 0) {
    // Exponent 1/roughness; it is read as a float, and 1e-30 is as good as 0.
    const double roughness = 1 / std::clamp(k.exponent, 1e-30, 1e30);
    text += fmt::format(
        " specular {0:.9g} roughness {1:.9g} reflection {{ rgb <{0:.9g},{0:.9g},"
        "{0:.9g}> }}",
        k.specular, roughness);
  }
  return text + " } }\n";
}

std::string plain_name(const Surface& surface) { return fmt::format("S{}", surface.number); }

}  // namespace

PovUv pov_uv(PrimitiveKind kind, int face) {
  switch (kind) {
    case PrimitiveKind::cube: {
      constexpr std::array kOfPair{PovUv::zy, PovUv::xz, PovUv::xy};
      return kOfPair[static_cast<std::size_t>(face / 2)];
    }
    case PrimitiveKind::sphere: return PovUv::ball;
    case PrimitiveKind::cone: return face == 0 ? PovUv::side : PovUv::cap;
    case PrimitiveKind::cylinder: return face == 2 ? PovUv::side : PovUv::cap;
  }
  return PovUv::cap;
}

std::string pov_texture_name(const Surface& surface, PovUv uv) {
  constexpr std::array kSuffix{"zy", "xz", "xy", "ball", "side", "cap"};
  if (surface.texture == TextureKind::plain) return plain_name(surface);
  return plain_name(surface) + "_" + kSuffix[static_cast<std::size_t>(uv)];
}

std::string pov_functions() {
  return R"(// Once around Y, from 0 at +X by +Z to 1.
#declare Turn = function(x,y,z) { atan2(z,x)/(2*pi) + select(atan2(z,x), 1, 0) }
// The face of a primitive that a point on it belongs to, in eighths.
#declare CubeFace = function(x,y,z) {
  select(abs(x) - min(abs(x),abs(1-x),abs(y),abs(1-y),abs(z),abs(1-z)), 0, 0,
  select(abs(1-x) - min(abs(1-x),abs(y),abs(1-y),abs(z),abs(1-z)), 0, 0.125,
  select(abs(y) - min(abs(y),abs(1-y),abs(z),abs(1-z)), 0, 0.25,
  select(abs(1-y) - min(abs(1-y),abs(z),abs(1-z)), 0, 0.375,
  select(abs(z) - min(abs(z),abs(1-z)), 0, 0.5, 0.625)))))
}
#declare ConeFace = function(x,y,z) {
  select(abs(sqrt(x*x+z*z)-1+y)/sqrt(2) - abs(y), 0, 0, 0.125)
}
#declare CylinderFace = function(x,y,z) {
  select(abs(y) - min(abs(y),abs(1-y),abs(1-sqrt(x*x+z*z))), 0, 0,
  select(abs(1-y) - min(abs(1-y),abs(1-sqrt(x*x+z*z))), 0, 0.125, 0.25))
}
)";
}

std::string pov_textures(const Surface& surface, const glm::dvec3& ambient,
                         const std::set<PovUv>& uses) {
  std::string text = fmt::format("// {} {}\n", surface.number, in_quotes(surface.name));
  const std::string name = plain_name(surface);
  text += fmt::format("#declare {} =\n{}", name, layers(surface.first, ambient));
  if (surface.texture == TextureKind::plain) return text;
  text += fmt::format("#declare {}_odd =\n{}", name, layers(surface.second, ambient));
  constexpr std::array<std::pair<const char*, const char*>, 6> kUv{{
      {"z", "y"},
      {"x", "z"},
      {"x", "y"},
      {"Turn(x,y,z)", "acos(max(-1,min(1,-y)))/pi"},
      {"Turn(x,y,z)", "y"},
      {"(x+1)/2", "(z+1)/2"},
  }};
  for (const PovUv uv : uses) {
    const auto [u, v] = kUv[static_cast<std::size_t>(uv)];
    text += fmt::format(
        "#declare {0} = texture {{\n"
        "  function {{ mod(min(floor(max({2},0)*{3}),{3}-1) + min(floor(max({4},0)*{5}),{5}-1), 2) "
        "}}\n"
        "  texture_map {{ [0 {1}] [1 {1}_odd] }}\n}}\n",
        pov_texture_name(surface, uv), name, u, surface.cells_u, v, surface.cells_v);
  }
  return text;
}

std::string pov_texture_of(const CsgNode& primitive, const std::vector<const Surface*>& of_face) {
  std::vector<std::string> names;
  for (std::size_t face = 0; face < of_face.size(); ++face)
    names.push_back(
        pov_texture_name(*of_face[face], pov_uv(primitive.kind, static_cast<int>(face))));
  if (std::all_of(names.begin(), names.end(), [&](const auto& n) { return n == names[0]; }))
    return fmt::format("texture {{ {} }}", names[0]);
  const char* function = primitive.kind == PrimitiveKind::cube   ? "CubeFace"
                         : primitive.kind == PrimitiveKind::cone ? "ConeFace"
                                                                 : "CylinderFace";
  std::string text = fmt::format("texture {{ function {{ {}(x,y,z) }} texture_map {{", function);
  for (std::size_t face = 0; face < names.size(); ++face)
    text += fmt::format(" [{} {}]", static_cast<double>(face) / 8, names[face]);
  return text + " } }";
}

}  // namespace sir
