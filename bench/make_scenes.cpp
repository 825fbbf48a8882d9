// Writes the scenes that speed is measured on, as BASE.CSG, BASE.CAM, BASE.LUZ and BASE.SUP.
// Usage: make_scenes DIR [MOST]   (up to MOST primitives, else all)
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>

#include "bench/scenes.h"
#include "tracer/scene_file.h"

int main(int count, char** arguments) try {
  if (count < 2 || count > 3) {
    std::fprintf(stderr, "usage: make_scenes DIR [MOST]\n");
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  const int most = count > 2 ? std::atoi(arguments[2]) : 30'000;
  std::filesystem::create_directories(folder);
  for (const auto& made : sir::bench::made_suite())
    if (made.primitives <= most)
      sir::write_scene(folder / made.name(), sir::bench::made_scene(made));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "make_scenes: %s\n", error.what());
  return 1;
}
