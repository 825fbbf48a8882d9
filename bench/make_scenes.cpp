// Writes the scenes that speed is measured on, as BASE.CSG, BASE.CAM, BASE.LUZ and BASE.SUP.
// Usage: make_scenes [--sizes LIST] DIR
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "bench/scenes.h"
#include "tracer/scene_file.h"

int main(int count, char** arguments) try {
  namespace bench = sir::bench;
  std::vector<int> sizes(std::begin(bench::kSizes), std::end(bench::kSizes));
  std::string folder;
  CLI::App app(
      "Writes the scenes that speed is measured on: mixed-N, chain-N, cut-N, distributed-N and "
      "spheres-N");
  app.add_option("DIR", folder, "folder of the scenes, made if need be")->required();
  app.add_option("--sizes", sizes, "numbers N of primitives, separated by commas (300,3000,30000)")
      ->delimiter(',')
      ->check(CLI::Range(1, 1'000'000));
  CLI11_PARSE(app, count, arguments);
  std::filesystem::create_directories(folder);
  for (const bench::MadeScene& made : bench::made_suite(sizes))
    sir::write_scene(std::filesystem::path(folder) / made.name(), bench::made_scene(made));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "make_scenes: %s\n", error.what());
  return 1;
}
