#include "cli/render_keeping.h"

#include <fmt/format.h>

#include "cli/render_settings.h"
#include "tracer/error.h"
#include "tracer/scene_path.h"
#include "tracer/text_file.h"

namespace sir::cli {

RenderKeeping::RenderKeeping(const RenderCommand& command, const Scene& scene,
                             const std::filesystem::path& base, const Session& session)
    : command_(command),
      path_(with_suffix(base, "tiles")),
      session_(session),
      record_({path_, [&] { return render_settings(scene, command.options, command.progressive); },
               command.keep_after,
               TileRecord::kMostBytes + 4 * std::uint64_t{command.options.size.pixels()},
               [session](const std::string& reason) {
                 note(session, reason + "; the render goes on and keeps no more finished tiles");
               }}) {}

void RenderKeeping::begin() {
  if (!command_.resume) {
    if (record_.can_resume())
      note(session_, path_.string() +
                         ": holds finished tiles of this render, which --resume would continue; "
                         "it begins anew");
    return;
  }
  const TileRecord::Resumed resumed = record_.resume();
  switch (resumed.found) {
    case TileRecord::Found::nothing:
      note(session_, path_.string() +
                         ": no finished tiles of an interrupted render (of one that is complete "
                         "none are left): rendered from the start");
      return;
    case TileRecord::Found::other:
      throw FileError(
          path_.string(), 0,
          "is of another render: " + settings_difference(record_.settings(), resumed.settings) +
              "; without --resume it is rendered anew");
    case TileRecord::Found::tiles:
      note(session_, fmt::format("{}: continued from {}", path_.string(),
                                 counted(resumed.tiles, "finished tile")));
      if (resumed.dropped > 0)
        detail(session_, fmt::format("{}: {} at the end are not whole tiles, and are dropped",
                                     path_.string(), counted(resumed.dropped, "byte")));
  }
}

void RenderKeeping::say_tiles() {
  if (command_.resume)
    detail(session_, fmt::format("{}: {} taken over, {} rendered", path_.string(),
                                 counted(record_.taken(), "tile"), record_.kept()));
}

void RenderKeeping::say_how_to_continue() {
  if (record_.flush())
    note(session_,
         fmt::format("{}: holds the finished tiles; the same command with --resume continues "
                     "from them",
                     path_.string()));
}

}  // namespace sir::cli
