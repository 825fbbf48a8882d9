#include "cli/planes_command.h"

#include <string>
#include <system_error>

#include "cli/image_input.h"
#include "tracer/error.h"
#include "tracer/scene_path.h"
#include "viewer/png_file.h"

namespace sir::cli {
namespace {

// The base name of what is written, beside the input or in --out.
std::filesystem::path output_base(const PlanesOptions& options) {
  const auto base = base_name(options.input);
  if (!options.folder) return base;
  std::error_code failure;
  std::filesystem::create_directories(*options.folder, failure);
  if (failure)
    throw FileError(options.folder->string(), 0, "cannot be created: " + failure.message());
  return *options.folder / base.filename();
}

}  // namespace

int run_planes(const PlanesOptions& options, const Session& session) {
  if (options.output && options.folder) {
    note(Session{}, "planes: -o and --out exclude each other");
    return kUsage;
  }
  const Planes planes = load_image(options.input, options.size);
  if (!is_png(options.input)) {
    const auto path = options.output.value_or(with_suffix(output_base(options), "png"));
    refuse_input_file(path, options.input);
    viewer::write_rgb_png(path, planes);
    detail(session, "wrote " + path.string());
    return kDone;
  }
  const auto base = options.output.value_or(output_base(options));
  refuse_input_file(base, options.input);  // -o FILE.png: a slip, not a base name
  for (int channel = 0; channel < 3; ++channel)
    refuse_input_file(plane_path(base, channel), options.input);
  write_planes(base, planes);
  print(base.string() + ": " + std::to_string(planes.size.width) + "x" +
        std::to_string(planes.size.height) + "\n");
  return kDone;
}

}  // namespace sir::cli
