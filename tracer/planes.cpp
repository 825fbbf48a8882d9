#include "tracer/planes.h"

#include <fstream>
#include <span>

#include "tracer/atomic_files.h"
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
  AtomicFiles files;
  write_planes(files, base, planes);
  files.commit();
}

void write_planes(AtomicFiles& files, const std::filesystem::path& base, const Planes& planes) {
  for (std::size_t c = 0; c < planes.channel.size(); ++c)
    files.add(plane_path(base, static_cast<int>(c)))
        .write(std::as_bytes(std::span(planes.channel[c])));
}

Planes read_planes(const std::filesystem::path& base, ImageSize size) {
  Planes planes(ImageSize{0, 0});
  planes.size = size;
  for (std::size_t c = 0; c < 3; ++c)
    planes.channel[c] = read_plane(find_by_suffix(base, kSuffix[c]), size);
  return planes;
}

}  // namespace sir
