#include "cli/export_command.h"

#include "tracer/atomic_file.h"
#include "tracer/scene_file.h"
#include "tracer/scene_path.h"

namespace sir::cli {

int run_export(const ExportCommand& command, const Session& session) {
  const Scene scene = read_scene(command.base);
  for (const char* input : {"CSG", "CAM", "LUZ", "SUP"})
    refuse_same_file(command.pov, find_by_suffix(command.base, input));
  PovOptions options = command.options;
  options.file = command.pov.filename().string();
  write_file_atomically(command.pov, pov_text(scene, options));
  note(session, "wrote " + command.pov.string());
  return kDone;
}

}  // namespace sir::cli
