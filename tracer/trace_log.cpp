#include "tracer/trace_log.h"

#include <algorithm>

#include <fmt/format.h>

namespace sir {
namespace {

std::string vector_text(const glm::dvec3& v) {
  return fmt::format("({:.6g} {:.6g} {:.6g})", v.x, v.y, v.z);
}

const char* kind_text(RayKind kind) {
  switch (kind) {
    case RayKind::primary: return "primary";
    case RayKind::reflected: return "reflected";
    case RayKind::refracted: return "refracted";
  }
  return "";
}

}  // namespace

std::string describe(const TraceLog& log, const Scene& scene) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (const TraceNode& node : log) {
    const std::string indent(static_cast<std::size_t>(node.depth - 1) * 2, ' ');
    fmt::format_to(out, "{}{} ray, depth {}, factor {:.6g}, weight {:.6g}\n", indent,
                   kind_text(node.kind), node.depth, node.factor, node.weight);
    fmt::format_to(out, "{}  from {} along {}\n", indent, vector_text(node.origin),
                   vector_text(node.direction));
    if (!node.hit) {
      fmt::format_to(out, "{}  leaves the scene: background {}\n", indent,
                     vector_text(node.colour));
      continue;
    }
    const Surface& surface = scene.surfaces[node.surface];
    const auto found = std::find_if(scene.tree.nodes.begin(), scene.tree.nodes.end(),
                                    [&](const CsgNode& n) { return n.number == node.node; });
    fmt::format_to(out, "{}  {} node {} \"{}\", face {}, surface {} \"{}\" at t = {:.9g}\n", indent,
                   node.entering ? "enters" : "leaves through", node.node, found->name, node.face,
                   surface.number, surface.name, node.t);
    fmt::format_to(out, "{}  point {} normal {}\n", indent, vector_text(node.point),
                   vector_text(node.normal));
    const Coefficients& k = node.coefficients;
    fmt::format_to(out, "{}  ka {} kd {} ks {:.6g} n {:.6g} kt {:.6g} ir {:.6g}{}\n", indent,
                   vector_text(k.ambient), vector_text(k.diffuse), k.specular, k.exponent,
                   k.transmission, k.index,
                   node.total_reflection ? ", total internal reflection" : "");
    for (std::size_t i = 0; i < node.lights.size(); ++i)
      fmt::format_to(out, "{}  light {} arrives with {}\n", indent, i + 1,
                     vector_text(node.lights[i]));
    fmt::format_to(out, "{}  local {} colour {}\n", indent, vector_text(node.local),
                   vector_text(node.colour));
  }
  return text;
}

}  // namespace sir
