// The image as SIR writes it: one byte plane per RGB primary (thesis 3.6.4).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace sir {

class AtomicFiles;

/// Width and height of an image in pixels.
struct ImageSize {
  int width = 640;
  int height = 480;
  std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

/// A colour as three stored bytes; 255 is full intensity.
struct Rgb8 {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb8&, const Rgb8&) = default;
};

/// Artifact of the tracer: three planes of width x height bytes, rows from
/// the top. channel[0] is R, channel[1] G, channel[2] B; the pixel in column
/// i and row j is at j * width + i of each.
struct Planes {
  ImageSize size;
  std::array<std::vector<std::uint8_t>, 3> channel;

  Planes() : Planes(ImageSize{0, 0}) {}
  explicit Planes(ImageSize image_size);

  Rgb8 at(std::size_t pixel) const {
    return {channel[0][pixel], channel[1][pixel], channel[2][pixel]};
  }
  void set(std::size_t pixel, Rgb8 colour) {
    channel[0][pixel] = colour.r;
    channel[1][pixel] = colour.g;
    channel[2][pixel] = colour.b;
  }
  friend bool operator==(const Planes&, const Planes&) = default;
};

/// The name of one plane's file: BASE.R, BASE.G or BASE.B.
std::filesystem::path plane_path(const std::filesystem::path& base, int channel);

/// Writes BASE.R, BASE.G and BASE.B. Throws FileError.
void write_planes(const std::filesystem::path& base, const Planes& planes);

/// The same as a part of `files`, whose commit() is the caller's.
void write_planes(AtomicFiles& files, const std::filesystem::path& base, const Planes& planes);

/// Reads the three planes of an image of the given size; the suffix may be
/// in upper or lower case. Throws FileError where a plane is missing or has
/// another length than width x height bytes.
Planes read_planes(const std::filesystem::path& base, ImageSize size);

}  // namespace sir
