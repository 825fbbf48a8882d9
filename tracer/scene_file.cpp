#include "tracer/scene_file.h"

#include <fmt/format.h>

#include "tracer/atomic_files.h"
#include "tracer/limits.h"
#include "tracer/scene_path.h"

namespace sir {
namespace {

const char* keyword(Operation operation) {
  switch (operation) {
    case Operation::union_of: return "UNIÃO";
    case Operation::difference: return "DIFERENÇA";
    case Operation::intersection: return "INTERSEÇÃO";
  }
  return "";
}

const char* keyword(PrimitiveKind kind) {
  switch (kind) {
    case PrimitiveKind::cube: return "CUBO";
    case PrimitiveKind::sphere: return "ESFERA";
    case PrimitiveKind::cone: return "CONE";
    case PrimitiveKind::cylinder: return "CILINDRO";
  }
  return "";
}

const char* node_type(const CsgNode& node) { return node.composite ? "COMPOSTO" : "PRIMITIVO"; }

// fmt writes the shortest decimals that read back to the same double.
std::string text_of(const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

std::string text_of(const Coefficients& k) {
  return fmt::format("{} {} {} {} {} {}", text_of(k.ambient), text_of(k.diffuse), k.specular,
                     k.exponent, k.transmission, k.index);
}

}  // namespace

Scene read_scene(const std::filesystem::path& base) {
  // All four are looked for first: a missing file is told before a long read.
  const auto csg_path = find_by_suffix(base, "CSG");
  const auto cam_path = find_by_suffix(base, "CAM");
  const auto luz_path = find_by_suffix(base, "LUZ");
  const auto sup_path = find_by_suffix(base, "SUP");
  TextFile csg(csg_path), cam(cam_path), luz(luz_path), sup(sup_path);
  Scene scene{read_csg(csg), read_camera(cam), read_lighting(luz), read_surfaces(sup)};
  check_surfaces(scene.tree, scene.surfaces, csg.name(), sup.name());
  return scene;
}

void require_at_most(const TextFile& file, std::int64_t announced, const char* things) {
  if (static_cast<std::uint64_t>(announced) > limits().nodes)
    file.fail("the file announces " + std::to_string(announced) + " " + things + "; " +
              at_most(limits().nodes, things, "--max-nodes"));
}

std::string csg_text(const CsgTree& tree) {
  std::string text = fmt::format("{}\n\n", tree.nodes.size());
  const auto out = std::back_inserter(text);
  for (const CsgNode& node : tree.nodes) {
    fmt::format_to(out, "{}\n{}\n{}\n", node.number, node.name, node_type(node));
    if (node.composite) {
      const CsgNode& left = tree.nodes[node.left];
      const CsgNode& right = tree.nodes[node.right];
      fmt::format_to(out, "{}\n{}\n{}\n{}\n{}\n\n", keyword(node.operation), node_type(left),
                     node_type(right), left.number, right.number);
      continue;
    }
    fmt::format_to(out, "{}\n{}", keyword(node.kind), node.surfaces[0]);
    if (node.surface_per_face)
      for (int face = 1; face < face_count(node.kind); ++face)
        fmt::format_to(out, " {}", node.surfaces[static_cast<std::size_t>(face)]);
    for (int line = 0; line < 3; ++line)
      fmt::format_to(out, "\n{} 0", text_of(node.placement.linear[line]));
    fmt::format_to(out, "\n{} 1\n\n", text_of(node.placement.translation));
  }
  return text;
}

std::string camera_text(const CameraFile& camera) {
  std::string text = fmt::format("{} {}\n{}\n{}\n{}\n{}\n", camera.window.x, camera.window.y,
                                 text_of(camera.target), text_of(camera.normal), camera.distance,
                                 text_of(camera.up));
  if (camera.parallel) text += "PARALELA\n";
  else if (camera.focal_given) text += fmt::format("{}\n", camera.focal);
  return text;
}

std::string lighting_text(const Lighting& lighting) {
  std::string text = fmt::format("{}\n{}\n{}\n", text_of(lighting.background),
                                 text_of(lighting.ambient), lighting.lights.size());
  for (const Light& light : lighting.lights)
    text += text_of(light.position) + " " + text_of(light.intensity) + "\n";
  return text;
}

std::string surfaces_text(const std::vector<Surface>& surfaces) {
  std::string text = fmt::format("{}\n\n", surfaces.size());
  for (const Surface& surface : surfaces) {
    const bool chequer = surface.texture == TextureKind::chequer;
    text += fmt::format("{}\n{}\n{}\n{}\n", surface.number, surface.name,
                        chequer ? "XADREZ" : "LISA", text_of(surface.first));
    if (chequer)
      text += fmt::format("{} {}\n{}\n", surface.cells_u, surface.cells_v, text_of(surface.second));
    text += "\n";
  }
  return text;
}

void write_scene(const std::filesystem::path& base, const Scene& scene) {
  AtomicFiles files;
  files.add(with_suffix(base, "CSG")).write(csg_text(scene.tree));
  files.add(with_suffix(base, "CAM")).write(camera_text(scene.camera));
  files.add(with_suffix(base, "LUZ")).write(lighting_text(scene.lighting));
  files.add(with_suffix(base, "SUP")).write(surfaces_text(scene.surfaces));
  files.commit();
}

}  // namespace sir
