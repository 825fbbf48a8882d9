// `sir render --resume`: what is said to the person about BASE.tiles (the thesis has none).
#pragma once

#include <filesystem>

#include "cli/render_command.h"
#include "tracer/scene.h"
#include "tracer/tile_record.h"

namespace sir::cli {

/// The record of a command's finished tiles. The command and the scene must outlive it.
class RenderKeeping {
 public:
  RenderKeeping(const RenderCommand& command, const Scene& scene, const std::filesystem::path& base,
                const Session& session);

  /// Before the render. With --resume takes the record up, and throws FileError for one
  /// that is of another render, is being written by another process or is no record; without it
  /// says that one could be continued.
  void begin();

  /// With -v, how many tiles were taken over and how many rendered.
  void say_tiles();

  /// After what ended the render too soon: one line, where there is something to continue from.
  void say_how_to_continue();

  TileRecord& record() { return record_; }

 private:
  const RenderCommand& command_;
  const std::filesystem::path path_;
  const Session session_;
  TileRecord record_;
};

}  // namespace sir::cli
