#include "interchange/pov_export.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include <fmt/format.h>

#include "interchange/pov_solid.h"
#include "interchange/pov_surface.h"
#include "interchange/pov_view.h"

namespace sir {
namespace {

// For a comment, which a line's end would end, and from there for a shell.
std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words)
    text += word.find(' ') == std::string::npos ? " " + word : " '" + word + "'";
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c >= 0 && c < ' '; }, '?');
  return text;
}

// POV-Ray splits its options at blanks unless they are in quotation marks.
std::string option_value(const std::string& name) {
  return name.find(' ') == std::string::npos ? name : '"' + name + '"';
}

constexpr const char* kHead =
    R"(// Written by `sir export` for POV-Ray 3.7. To render it as `sir render` does:
//   povray{arguments}
//
// The same: camera, solid, chequers, illumination in each channel (ambient, diffuse, highlight by
// the half vector, mirror, glass), shadows dimmed by the transparency of every surface passed,
// bytes proportional to the intensity. max_trace_level counts as --depth does.
//
// Not the same:
// - Total reflection: POV-Ray gives the mirrored ray the weight 1, sir ks + kt.
// - Faces that coincide: POV-Ray has no rule for them and speckles them, or shows another one.
// - POV-Ray's tolerances are absolute: nothing is met nearer than 0.0001 to a ray's start, no
//   shadow nearer than 0.001; and its bounding boxes are of single precision.
// - Where transparent surfaces of one solid differ in their index of refraction, POV-Ray takes one
//   of them for the whole solid; where solids of different indices overlap, it takes the last one
//   entered until that is left.
// - An eye within an opaque union sees its inner walls. An eye within glass is taken to be there
//   twice where another surface stands between it and the screen.
// - max_trace_level is at most 256.
)";

std::string scale_comment(const PovFrame& frame, PovScale scale) {
  if (scale == PovScale::keep) return "//\n// Lengths are those of the files (--scale keep).\n";
  return fmt::format(
      "//\n"
      "// Lengths (--scale fit): p' = {:.17g} (p - {}).\n"
      "// The factor is the power of two that brings the diagonal of the box around all "
      "primitives,\n"
      "// the screen's centre and the eye to 524288..1048576; the point is that box's centre, "
      "rounded\n"
      "// to whole multiples of a power of two not below the diagonal. So POV-Ray's tolerances are "
      "a\n"
      "// thousand-millionth of the scene.\n",
      frame.factor, pov_vector(frame.centre));
}

std::map<std::int64_t, std::set<PovUv>> surface_uses(const Scene& scene) {
  std::map<std::int64_t, std::set<PovUv>> uses;
  for (const CsgNode& node : scene.tree.nodes) {
    if (node.composite) continue;
    for (int face = 0; face < face_count(node.kind); ++face)
      uses[node.surfaces[static_cast<std::size_t>(face)]].insert(pov_uv(node.kind, face));
  }
  return uses;
}

// POV-Ray's primary rays come from the eye, ours from the screen. What lies
// between shall be in mirrors and shadows only.
std::string visible_parts(const Scene& scene, const PovFrame& frame, const std::string& interior) {
  const std::string medium = interior.empty() ? "" : " " + interior;
  if (!reaches_before_screen(scene)) return "object { Solid" + medium + " }\n";
  return fmt::format(
      "// Something may stand between the eye and the screen: it is not seen there, yet it casts\n"
      "// shadows and is seen in mirrors, though not through glass.\n"
      "union {{\n"
      "  object {{ Solid clipped_by {{ {} }} no_shadow no_reflection }}\n"
      "  object {{ Solid no_image }}\n"
      " {}}}\n",
      pov_half_space_of_scene(scene, frame), medium.empty() ? "" : medium + "\n");
}

}  // namespace

std::vector<std::string> pov_arguments(const std::string& scene, const std::string& png,
                                       ImageSize size) {
  return {"+I" + option_value(scene),
          "+O" + option_value(png),
          fmt::format("+W{}", size.width),
          fmt::format("+H{}", size.height),
          "+FN8",
          "File_Gamma=1.0",
          "Dither=off",
          "-A",
          "-D",
          "-P",
          "+SU"};
}

std::string pov_text(const Scene& scene, const PovOptions& options) {
  const PovFrame frame = options.scale == PovScale::fit ? fitting_frame(scene) : PovFrame{};
  const auto png = std::filesystem::path(options.file).replace_extension(".png");
  std::string text = fmt::format(
      fmt::runtime(kHead),
      fmt::arg("arguments", joined(pov_arguments(options.file, png.string(), options.size))));
  text += scale_comment(frame, options.scale);
  text += fmt::format(
      "#version 3.7;\n"
      "global_settings {{ assumed_gamma 1 ambient_light 1 max_trace_level {} adc_bailout 0 }}\n"
      "#default {{ finish {{ ambient 0 diffuse 0 }} }}\n\n",
      options.depth_limit);
  text += pov_view(scene, frame) + "\n" + pov_functions() + "\n";
  const auto uses = surface_uses(scene);
  for (const Surface& surface : scene.surfaces)
    if (const auto found = uses.find(surface.number); found != uses.end())
      text += pov_textures(surface, scene.lighting.ambient, found->second);
  const PovSolid solid = pov_solid(scene, frame);
  return text + "\n#declare Solid =\n" + solid.text + "\n" +
         visible_parts(scene, frame, solid.interior);
}

}  // namespace sir
