#include "modeler/look_text.h"

#include <fmt/format.h>

#include "modeler/command_line.h"
#include "modeler/look_words.h"

namespace sir::modeler {
namespace {

std::string text_of(const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

std::string text_of(const Coefficients& k) {
  return fmt::format(" ambient {} diffuse {} specular {} exponent {} transmission {} index {}",
                     text_of(k.ambient), text_of(k.diffuse), k.specular, k.exponent, k.transmission,
                     k.index);
}

}  // namespace

std::string camera_line(const CameraFile& camera) {
  return fmt::format("camera window {} {} target {} normal {} distance {} up {} focal {} {}",
                     camera.window.x, camera.window.y, text_of(camera.target),
                     text_of(camera.normal), camera.distance, text_of(camera.up),
                     camera.focal_given ? fmt::format("{}", camera.focal) : "auto",
                     camera.parallel ? "parallel" : "perspective");
}

std::string camera_line(const std::optional<CameraFile>& camera) {
  return camera ? camera_line(*camera) : "camera auto";
}

std::string light_line(const Lighting& lighting) {
  std::string line = fmt::format("light set background {} ambient {}", text_of(lighting.background),
                                 text_of(lighting.ambient));
  for (const Light& light : lighting.lights)
    line += fmt::format(" add {} {}", text_of(light.position), text_of(light.intensity));
  return line;
}

std::string light_line(const std::optional<Lighting>& lighting) {
  return lighting ? light_line(*lighting) : "light auto";
}

std::string surface_line(const Surface& surface) {
  std::string line = fmt::format("surface {} name {}{}", surface.number, as_word(surface.name),
                                 text_of(surface.first));
  if (surface.texture == TextureKind::plain) return line + " plain";
  return line + fmt::format(" chequer {} {} odd{}", surface.cells_u, surface.cells_v,
                            text_of(surface.second));
}

std::vector<std::string> view_lines(const ViewSettings& view, const ViewSettings& besides) {
  std::vector<std::string> lines;
  for (const auto& word : view_words())
    if (view.*word.value != besides.*word.value)
      lines.push_back(fmt::format("view {} {}", word.english, view.*word.value ? "on" : "off"));
  return lines;
}

std::string select_line(const std::optional<Selection>& selection) {
  if (!selection) return "select";
  std::string line = "select " + as_word(selection->solid);
  if (selection->place != 0 || selection->face) line += fmt::format(" {}", selection->place);
  if (selection->face) line += fmt::format(" {}", *selection->face);
  return line;
}

}  // namespace sir::modeler
