#include "tracer/planes.h"

#include <fstream>
#include <span>

#include "tracer/atomic_file.h"
#include "tracer/error.h"
#include "tracer/scene_path.h"

namespace sir {
namespace {

constexpr std::array<const char*, 3> kSuffix = {"R", "G", "B"};

std::vector<std::uint8_t> read_plane(const std::filesystem::path& path, ImageSize size) {
  std::error_code failure;
  const auto length = std::filesystem::file_size(path, failure);
  if (failure) throw FileError(path.string(), 0, "cannot be read: " + failure.message());
  if (length != size.pixels())
    throw FileError(path.string(), 0,
                    "holds " + std::to_string(length) + " bytes where an image of " +
                        std::to_string(size.width) + "x" + std::to_string(size.height) + " has " +
                        std::to_string(size.pixels()) + "; another size is given by --size WxH");
  std::vector<std::uint8_t> bytes(size.pixels());
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file) throw FileError(path.string(), 0, "cannot be read");
  return bytes;
}

}  // namespace

Planes::Planes(ImageSize image_size) : size(image_size) {
  for (auto& plane : channel) plane.resize(size.pixels());
}

std::filesystem::path plane_path(const std::filesystem::path& base, int channel) {
  return with_suffix(base, kSuffix.at(static_cast<std::size_t>(channel)));
}

void write_planes(const std::filesystem::path& base, const Planes& planes) {
  // All three are on the disk before the first takes its name: a full disk leaves the old image
  // whole, and who watches the files sees the three change at once or nearly so.
  std::array<std::filesystem::path, 3> paths{plane_path(base, 0), plane_path(base, 1),
                                             plane_path(base, 2)};
  AtomicFile r(paths[0]), g(paths[1]), b(paths[2]);
  r.write(std::as_bytes(std::span(planes.channel[0])));
  g.write(std::as_bytes(std::span(planes.channel[1])));
  b.write(std::as_bytes(std::span(planes.channel[2])));
  for (AtomicFile* plane : {&r, &g, &b}) plane->flush();
  r.commit();
  g.commit();
  b.commit();
}

Planes read_planes(const std::filesystem::path& base, ImageSize size) {
  Planes planes(ImageSize{0, 0});
  planes.size = size;
  for (std::size_t c = 0; c < 3; ++c)
    planes.channel[c] = read_plane(find_by_suffix(base, kSuffix[c]), size);
  return planes;
}

}  // namespace sir
