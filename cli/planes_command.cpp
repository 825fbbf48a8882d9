#include "cli/planes_command.h"

#include <string>

#include "cli/image_input.h"
#include "cli/output_path.h"
#include "tracer/scene_path.h"
#include "viewer/png_file.h"

namespace sir::cli {

int run_planes(const PlanesOptions& options, const Session& session) {
  const Planes planes = load_image(options.input, options.size);
  const auto beside = output_base(base_name(options.input), options.folder);
  if (!is_png(options.input)) {
    const auto path = options.output.value_or(with_suffix(beside, "png"));
    refuse_input_file(path, options.input);
    viewer::write_rgb_png(path, planes);
    detail(session, "wrote " + path.string());
    return kDone;
  }
  const auto base = options.output.value_or(beside);
  refuse_input_file(base, options.input);  // -o FILE.png: a slip, not a base name
  for (int channel = 0; channel < 3; ++channel)
    refuse_input_file(plane_path(base, channel), options.input);
  write_planes(base, planes);
  print(base.string() + ": " + std::to_string(planes.size.width) + "x" +
        std::to_string(planes.size.height) + "\n");
  return kDone;
}

}  // namespace sir::cli
