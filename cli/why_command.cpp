#include "cli/why_command.h"

#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/image_input.h"
#include "cli/why_json.h"
#include "tracer/error.h"
#include "tracer/scene_file.h"
#include "tracer/scene_path.h"
#include "viewer/inspection.h"
#include "viewer/rendition.h"

namespace sir::cli {
namespace {

// By the LUT that show would take, unless a method is asked for.
viewer::Rendition shown_by(const viewer::Picture& picture, const WhyOptions& options) {
  const viewer::RenditionOptions how{options.map, options.lut};
  const bool from_file = !options.method && viewer::lut_file(picture.base, how);
  const auto otherwise = options.method.value_or(viewer::Method::hsv_median);
  return viewer::make_rendition(picture, from_file ? viewer::Method::lut_file : otherwise, how);
}

// The scene behind BASE, if it is there; a broken one leaves the rest of the answer as it is.
std::shared_ptr<const Scene> scene_of(const WhyOptions& options, const Session& session) {
  if (is_png(options.input) || !existing_by_suffix(options.input, "CSG")) return nullptr;
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
