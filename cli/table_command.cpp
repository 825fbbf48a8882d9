#include "cli/table_command.h"

#include <array>

#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/report_html.h"
#include "cli/scratch_folder.h"
#include "cli/table_text.h"
#include "tracer/atomic_file.h"
#include "tracer/error.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"
#include "tracer/scene_path.h"

namespace sir::cli {
namespace {

namespace fs = std::filesystem;

fs::path find_images(const std::optional<fs::path>& given) {
  if (given) return *given;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  const std::array<fs::path, 3> places{"images", program / "../../images",
                                       program / "../share/sir/images"};
  for (const fs::path& place : places)
    if (fs::exists(place / "whitted.CSG", ignored)) return place.lexically_normal();
  throw FileError("images", 0,
                  "the folder of the five scenes is not here; name it by --images DIR");
}

// The report must not take the place of what it is made from.
void refuse_inputs(const fs::path& html, const fs::path& base) {
  for (const char* suffix :
       {"CSG", "csg", "CAM", "cam", "LUZ", "luz", "SUP", "sup", "R", "r", "G", "g", "B", "b"})
    refuse_same_file(html, with_suffix(base, suffix));
}

}  // namespace

int run_table(const TableCommand& command, const Session& session) {
  const ScratchFolder scratch;
  TableData data;
  const fs::path images = command.planes ? fs::path() : find_images(command.images);
  if (command.html)
    for (const ThesisRow& thesis : kThesisTable)
      refuse_inputs(*command.html, command.planes.value_or(images) / thesis.file);
  if (command.html) require_writable(*command.html);
  for (const ThesisRow& thesis : kThesisTable) {
    fs::path planes = command.planes.value_or(scratch.path()) / thesis.file;
    if (!command.planes) {
      const Scene scene = read_scene(images / thesis.file);
      Progress progress(session, thesis.file);
      const auto result = render(scene, {}, progress.callback(), interruption());
      if (!result.complete) return kInterrupted;
      write_planes(planes, result.planes);
    }
    data.rows.push_back(measure_row(thesis, planes, scratch.path(), command.repeats));
    if (interrupted()) return kInterrupted;
  }
  data.clock = clock_of(data.rows);
  if (command.html) {
    write_file_atomically(*command.html, report_html(data, scratch.path()));
    note(session, "wrote " + command.html->string());
  }
  print(command.json ? table_json(data) : table_text(data));
  return kDone;
}

}  // namespace sir::cli
