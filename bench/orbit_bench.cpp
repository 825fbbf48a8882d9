// Frames a second of a camera that goes round `whitted`: 640x480, depth 5, all threads.
// Usage: orbit_bench [FRAMES [SCENE]]   (36 frames of images/whitted)
// The scene is made ready once for each precision; a frame changes the camera only. Beside it
// what POV-Ray takes for the first of the frames, start and parsing included.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "bench/child.h"
#include "bench/scratch.h"
#include "bench/timing.h"
#include "interchange/pov_export.h"
#include "tracer/recentre.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"

namespace {

namespace fs = std::filesystem;
using namespace sir;
using namespace sir::bench;

constexpr ImageSize kSize{640, 480};

// v turned about the axis, of unit length (Rodrigues).
glm::dvec3 turned(glm::dvec3 v, glm::dvec3 axis, double angle) {
  return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
         axis * glm::dot(axis, v) * (1 - std::cos(angle));
}

// The camera on a circle about the target, in the plane across its up vector.
CameraFile orbited(CameraFile camera, double angle) {
  camera.normal = turned(camera.normal, glm::normalize(camera.up), angle);
  return camera;
}

template <typename T>
void run(const char* name, const Scene& given, Precision precision, int frames) {
  RenderOptions options;
  options.size = kSize;
  options.precision = precision;
  const Scene scene = Recentred(given, offset_for(given, precision));
  Model<T> model(scene, options.trace.possible_effects());
  const double prepare =
      milliseconds([&] { (void)Model<T>(scene, options.trace.possible_effects()); });
  std::vector<double> ms;
  const double cpu_before = own_cpu_seconds();
  for (int frame = 0; frame < frames; ++frame) {
    model.camera = Camera<T>(orbited(scene.camera, 2 * std::numbers::pi * frame / frames));
    ms.push_back(milliseconds([&] { (void)render_model(model, options); }));
  }
  const double cpu = (own_cpu_seconds() - cpu_before) / frames;
  double sum = 0;
  for (const double one : ms) sum += one;
  std::printf(
      "%-6s %d frames: %6.2f a second, median %.1f ms a frame, of the CPUs %.1f ms; made ready "
      "once "
      "in %.2f ms\n",
      name, frames, 1e3 * frames / sum, median(ms), 1e3 * cpu, prepare);
}

void run_povray(const Scene& scene) {
  const Scratch scratch;
  fs::current_path(scratch.path);
  PovOptions options;
  options.file = "scene.pov";
  options.size = kSize;
  options.scale = PovScale::keep;  // faster: see speed_duel.cpp
  std::ofstream("scene.pov") << pov_text(scene, options);
  std::vector<std::string> words{"povray"};
  for (const std::string& word : pov_arguments("scene.pov", "scene.png", kSize))
    if (!word.starts_with("+O") && !word.starts_with("+F")) words.push_back(word);
  words.push_back("-F");
  std::optional<double> cpu;
  const double wall = milliseconds([&] { cpu = child_cpu_seconds(words); });
  if (cpu) std::printf("POV-Ray, one frame: %.0f ms, of the CPUs %.0f ms\n", wall, 1e3 * *cpu);
  else std::printf("no POV-Ray beside it: Debian's package is povray\n");
  fs::current_path("/");
}

}  // namespace

int main(int count, char** arguments) try {
  const int frames = count > 1 ? std::atoi(arguments[1]) : 36;
  if (count > 3 || frames < 1) {
    std::fprintf(stderr, "usage: orbit_bench [FRAMES [SCENE]]\n");
    return 2;
  }
  const Scene scene = read_scene(count > 2 ? arguments[2] : "images/whitted");
  run<double>("double", scene, Precision::double_, frames);
  run<float>("float", scene, Precision::float_, frames);
  run_povray(scene);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "orbit_bench: %s\n", error.what());
  return 1;
}
