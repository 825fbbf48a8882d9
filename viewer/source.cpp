#include "viewer/source.h"

#include <algorithm>
#include <string>

#include "tracer/error.h"
#include "tracer/scene_file.h"
#include "tracer/scene_path.h"
#include "viewer/image_name.h"

namespace sir::viewer {
namespace {

namespace fs = std::filesystem;

const auto kScene = {"CSG", "CAM", "LUZ", "SUP"};
const auto kPlanes = {"R", "G", "B"};

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(file, ignored);
}

// The earliest of times for a file that has just gone.
fs::file_time_type time_of(const fs::path& file) {
  std::error_code failure;
  const auto time = fs::last_write_time(file, failure);
  return failure ? fs::file_time_type::min() : time;
}

// Planes are shown whatever the scene is like.
std::shared_ptr<const Scene> scene_behind(const Source& source) {
  try {
    if (existing_by_suffix(source.base(), "CSG"))
      return std::make_shared<const Scene>(read_scene(source.base()));
  } catch (const FileError&) {
    // No words: the files may well be of something else.
  }
  return nullptr;
}

[[noreturn]] void refuse_nothing(const Source& source) {
  throw FileError(source.input().string(), 0,
                  "is no image: there is neither a scene (.CSG .CAM .LUZ .SUP) nor planes "
                  "(.R .G .B) of that name");
}

}  // namespace

Source::Source(const fs::path& input) : input_(given_base(input)), base_(base_name(input_)) {}

std::vector<fs::path> Source::files_of(std::initializer_list<const char*> suffixes) const {
  std::vector<fs::path> files;
  for (const char* suffix : suffixes)
    files.push_back(existing_by_suffix(base_, suffix).value_or(with_suffix(base_, suffix)));
  return files;
}

std::vector<fs::path> Source::files() const {
  if (is_png(input_)) return {input_};
  auto files = files_of(kScene);
  std::ranges::move(files_of(kPlanes), std::back_inserter(files));
  return files;
}

bool Source::planes_are_current() const {
  const auto planes = files_of(kPlanes);
  if (is_png(input_) || !std::ranges::all_of(planes, is_there)) return false;
  const auto oldest = std::ranges::min(planes, {}, time_of);
  return std::ranges::none_of(files_of(kScene), [&](const fs::path& file) {
    return is_there(file) && time_of(file) > time_of(oldest);
  });
}

bool Source::is_to_be_rendered() const {
  return !is_png(input_) && std::ranges::any_of(files_of(kScene), is_there) &&
         !planes_are_current();
}

void refuse_special_file(const fs::path& file) {
  std::error_code ignored;
  const auto status = fs::status(file, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw FileError(file.string(), 0, "is no regular file, which alone can be read again");
}

SourceContents read_source(const Source& source, ImageSize size) {
  const auto files = source.files();
  std::ranges::for_each(files, refuse_special_file);
  if (source.is_to_be_rendered())
    return {nullptr, std::make_shared<const Scene>(read_scene(source.base()))};
  if (!is_png(source.input()) && std::ranges::none_of(files, is_there)) refuse_nothing(source);
  auto picture = std::make_shared<Picture>();
  picture->input = source.input();
  picture->base = source.base();
  picture->planes = load_image(source.input(), size);
  if (!is_png(source.input())) picture->scene = scene_behind(source);
  return {std::move(picture), nullptr};
}

}  // namespace sir::viewer
