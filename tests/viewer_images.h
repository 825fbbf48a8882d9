// Inputs of the viewer, for tests.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "tests/temp_folder.h"
#include "tracer/planes.h"

namespace sir::test {

/// A small scene BASE.CSG .CAM .LUZ .SUP: a sphere before a cube. Another red is another picture.
inline void write_small_scene(const TempFolder& folder, const std::string& base, double red = 0.5) {
  folder.write(base + ".CSG",
               "3\n\n0\nall\nCOMPOSTO\nUNIAO\nPRIMITIVO\nPRIMITIVO\n1\n2\n\n"
               "1\nbox\nPRIMITIVO\nCUBO\n1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n\n"
               "2\nball\nPRIMITIVO\nESFERA\n1\n.5 0 0 0\n0 .5 0 0\n0 0 .5 0\n1 1 1 1\n");
  folder.write(base + ".CAM", "4 3\n.5 .5 .5\n-1 -1 -1\n4\n0 1 0\n");
  folder.write(base + ".LUZ", "0 0 .2\n.1\n1\n5 6 7 1\n");
  folder.write(base + ".SUP",
               "1\n\n1\nmatt\nLISA\n.1 .1 .3 " + std::to_string(red) + " .1 .8 .2 20 0 0\n");
}

/// A size at which write_slow_scene()'s takes far longer than the tests that it is rendered for.
inline constexpr ImageSize kSlowSize{3000, 2000};

/// Copies Whitted's scene, all mirrors and glass, to BASE.
inline void write_slow_scene(const TempFolder& folder, const std::string& base) {
  for (const char* suffix : {".CSG", ".CAM", ".LUZ", ".SUP"})
    std::filesystem::copy_file(std::string(SIR_IMAGES "/whitted") + suffix,
                               folder / (base + suffix));
}

/// All of one colour.
inline Planes plain_planes(ImageSize size, Rgb8 colour) {
  Planes planes(size);
  for (std::size_t i = 0; i < size.pixels(); ++i) planes.set(i, colour);
  return planes;
}

/// Makes a file so many seconds old.
inline void set_age(const std::filesystem::path& file, int seconds) {
  std::filesystem::last_write_time(
      file, std::filesystem::file_time_type::clock::now() - std::chrono::seconds(seconds));
}

}  // namespace sir::test
