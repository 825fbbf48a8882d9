#include "cli/why_command.h"

#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/image_input.h"
#include "cli/why_json.h"
#include "quant/best.h"
#include "quant/shown_through.h"
#include "tracer/error.h"
#include "tracer/scene_file.h"
#include "tracer/scene_path.h"
#include "viewer/inspection.h"

namespace sir::cli {
namespace {

// The LUT that show would take, unless a method is asked for.
std::optional<std::filesystem::path> file_of(const WhyOptions& options,
                                             const std::filesystem::path& base) {
  if (options.lut || options.method) return options.lut;
  for (const char* suffix : {"LUT", "lut"})
    if (auto path = with_suffix(base, suffix); std::filesystem::exists(path)) return path;
  return std::nullopt;
}

quant::Lut chosen(const Planes& planes, viewer::Method method) {
  if (const auto choice = viewer::choice_of(method)) return quant::choose_lut(planes, *choice);
  quant::WeightedColours colours;
  colours.add(planes);
  return quant::choose_best(colours).lut;
}

viewer::Rendition shown_by(const viewer::Picture& picture, const WhyOptions& options) {
  viewer::Rendition rendition;
  if (const auto path = file_of(options, picture.base)) {
    rendition.method = viewer::Method::lut_file;
    rendition.lut = quant::read_lut(*path);
    rendition.lut_name = path->filename().string();
  } else {
    rendition.method = options.method.value_or(viewer::Method::hsv_median);
    rendition.lut = chosen(picture.planes, rendition.method);
    rendition.lut_name = fmt::format("chosen by {}", viewer::name(rendition.method));
  }
  rendition.reserved = options.map.reserved;
  rendition.indices = quant::map_image(picture.planes, rendition.lut, options.map);
  rendition.seen = quant::as_seen(picture.planes.size, rendition.indices, rendition.lut);
  return rendition;
}

// The scene behind BASE, if it is there; a broken one leaves the rest of the answer as it is.
std::shared_ptr<const Scene> scene_of(const WhyOptions& options, const Session& session) {
  if (is_png(options.input)) return nullptr;
  bool there = false;
  for (const char* suffix : {"CSG", "csg"})
    there = there || std::filesystem::exists(with_suffix(options.input, suffix));
  if (!there) return nullptr;
  try {
    return std::make_shared<const Scene>(read_scene(options.input));
  } catch (const FileError& error) {
    note(session, fmt::format("no ray is told: {}", error.what()));
    return nullptr;
  }
}

}  // namespace

int run_why(const WhyOptions& options, const Session& session) {
  viewer::Picture picture;
  picture.input = options.input;
  picture.base = base_name(options.input);
  picture.planes = load_image(options.input, options.size);
  const ImageSize size = picture.planes.size;
  if (options.column < 0 || options.row < 0 || options.column >= size.width ||
      options.row >= size.height)
    throw FileError(options.input.string(), 0,
                    fmt::format("has {}x{} pixels; {},{} is none of them", size.width, size.height,
                                options.column, options.row));
  picture.scene = scene_of(options, session);
  const auto shared = std::make_shared<const viewer::Picture>(std::move(picture));
  const auto rendition = std::make_shared<const viewer::Rendition>(shown_by(*shared, options));
  viewer::Inspector inspector(shared, rendition, options.map);
  const viewer::Inspection found = inspector.inspect(options.column, options.row);
  std::string text;
  if (options.json) text = inspection_json(found).dump() + "\n";
  else
    for (const std::string& line : describe(found)) text += line + "\n";
  print(text);
  return kDone;
}

}  // namespace sir::cli
