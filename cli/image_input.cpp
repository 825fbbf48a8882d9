#include "cli/image_input.h"

#include <initializer_list>

#include "tracer/atomic_file.h"
#include "tracer/scene_path.h"

namespace sir::cli {

void refuse_input_file(const std::filesystem::path& output, const std::filesystem::path& input) {
  const auto refuse = [&](std::initializer_list<const char*> suffixes) {
    for (const char* suffix : suffixes)
      refuse_same_file(output, with_suffix(base_name(input), suffix));
  };
  if (is_png(input)) refuse_same_file(output, input);
  else refuse({"R", "G", "B", "r", "g", "b"});
  // A slip of the suffix must not cost the scene that the image came from.
  refuse({"CSG", "CAM", "LUZ", "SUP", "csg", "cam", "luz", "sup"});
}

}  // namespace sir::cli
