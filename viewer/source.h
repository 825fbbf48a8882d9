// What an opened image is made from: a PNG file, planes, or a scene (thesis 3.6).
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "tracer/planes.h"
#include "tracer/scene.h"
#include "viewer/picture.h"

namespace sir::viewer {

/// An input name and its files, which may come, go and change at any time: each answer is that of
/// the moment of asking.
class Source {
 public:
  /// FILE.png, BASE, or one of the files of BASE (see given_base).
  explicit Source(const std::filesystem::path& input);

  const std::filesystem::path& input() const { return input_; }
  const std::filesystem::path& base() const { return base_; }

  /// Where its files are, and the upper-case names of those that are not there: the PNG, or four
  /// of a scene and three planes.
  std::vector<std::filesystem::path> files() const;

  /// Whether all three planes are there and none is older than a file of the scene, by the file
  /// system's clock: within one tick of it, an edited scene seems no newer.
  bool planes_are_current() const;

  /// Whether a file of a scene is there and the planes are not, or are older.
  bool is_to_be_rendered() const;

 private:
  std::vector<std::filesystem::path> files_of(std::initializer_list<const char*> suffixes) const;

  std::filesystem::path input_, base_;
};

/// Refuses (FileError) a pipe, a folder and the like: it cannot be read again after a change.
void refuse_special_file(const std::filesystem::path& file);

/// What was read: a picture, or a scene that is to be rendered to one.
struct SourceContents {
  std::shared_ptr<const Picture> picture;
  std::shared_ptr<const Scene> scene;
};

/// Reads the PNG, the planes with the scene behind them, or the scene alone where that is to be
/// rendered. Planes have `size`, by which a scene must not be judged: one that is damaged leaves
/// current planes without one. Throws FileError, also for a special file.
SourceContents read_source(const Source& source, ImageSize size);

}  // namespace sir::viewer
