#include "bench/peers_orbit.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "bench/child.h"
#include "bench/peers_programs.h"
#include "bench/timing.h"
#include "tracer/recentre.h"
#include "tracer/render.h"

namespace sir::bench {
namespace {

constexpr ImageSize kSize{640, 480};
constexpr int kThreads = 2;

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
class Orbit {
 public:
  Orbit(const Scene& scene, Precision precision)
      : scene_(scene, offset_for(scene, precision)),
        options_(options(precision)),
        model_(scene_, options_.trace.possible_effects()) {}

  void begin_round() { ms_.push_back(0), cpu_ms_.push_back(0); }

  void frame(double angle) {
    const Scene& scene = scene_;
    model_.camera = Camera<T>(orbited(scene.camera, angle));
    const double before = own_cpu_seconds();
    ms_.back() += milliseconds([&] { (void)render_model(model_, options_); });
    cpu_ms_.back() += 1e3 * (own_cpu_seconds() - before);
  }

  void tell(const char* name, int frames, Demand demand, SpeedTable& table) const {
    std::vector<double> a_second;
    for (const double ms : ms_) a_second.push_back(1e3 * frames / ms);
    char detail[64];
    std::snprintf(detail, sizeof detail, "a second; one takes %.1f ms", median(ms_) / frames);
    table.line(std::string("frames in ") + name, detail, Quartiles(a_second), demand);
    table.line("", "CPUs that they had", Quartiles(ratios(cpu_ms_, ms_)));
  }

 private:
  static RenderOptions options(Precision precision) {
    RenderOptions options;
    options.size = kSize;
    options.precision = precision;
    options.threads = kThreads;
    return options;
  }

  Recentred scene_;
  RenderOptions options_;
  Model<T> model_;
  std::vector<double> ms_, cpu_ms_;  // of each round
};

}  // namespace

void measure_orbit(const Scene& scene, int rounds, int frames, bool povray,
                   const std::filesystem::path& folder, SpeedTable& table) {
  table.begin("orbit: whitted, 640x480, depth 5, " + std::to_string(frames) +
              " frames on two threads, wall time");
  Orbit<double> in_double(scene, Precision::double_);
  Orbit<float> in_float(scene, Precision::float_);
  std::vector<double> pov;
  if (povray) write_pov(folder, scene, kSize, RenderOptions{}.trace.depth_limit);
  for (int round = 0; round < rounds; ++round) {
    in_double.begin_round();
    in_float.begin_round();
    for (int frame = 0; frame < frames; ++frame) {
      const double angle = 2 * std::numbers::pi * frame / frames;
      in_double.frame(angle);
      in_float.frame(angle);
    }
    if (povray) pov.push_back(milliseconds([&] { seconds_of(pov_words(kSize, kThreads, false)); }));
  }
  in_double.tell("double", frames, {15, 0}, table);
  in_float.tell("float", frames, {0, 30}, table);
  if (povray) table.line("POV-Ray, one frame", "ms, with start and parsing", Quartiles(pov));
}

}  // namespace sir::bench
