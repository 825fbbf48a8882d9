// What the parts of tracing cost, by Google Benchmark.
// Usage: part_bench [--benchmark_filter=...] [--benchmark_repetitions=N] ...
// Run it from the project's folder, or say where the images are: SIR_IMAGES=DIR.
#include <cstdio>

#ifdef SIR_HAS_BENCHMARK

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <random>
#include <string>

#include "bench/first_hits.h"
#include "bench/scenes.h"
#include "tracer/scene_file.h"
#include "tracer/shade.h"
#include "tracer/trace.h"

namespace {

using namespace sir;
using namespace sir::bench;

// Rays towards points in and about the primitive, so that some miss and most hit.
template <typename T>
std::vector<LocalRay<T>> local_rays() {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<LocalRay<T>> rays;
  for (int i = 0; i < 1024; ++i) {
    const glm::dvec3 from = 4.0 * glm::dvec3(any(random), any(random), any(random));
    const glm::dvec3 to(any(random), any(random), any(random));
    rays.push_back({{glm::vec<3, T>(from)}, {glm::vec<3, T>(to - from)}, T(1), {}, {}, T(0)});
  }
  return rays;
}

template <typename T>
void intersect_primitive(benchmark::State& state, PrimitiveKind kind) {
  const auto rays = local_rays<T>();
  std::size_t i = 0;
  Span<T> span;
  for (auto _ : state) {
    benchmark::DoNotOptimize(intersect(kind, rays[i], span));
    benchmark::DoNotOptimize(span);
    i = (i + 1) % rays.size();
  }
}

// A made scene with rays and hits in an order that is no image's: caches get no help from
// neighbouring pixels, so these are above the times of a frame.
template <typename T>
struct Prepared {
  Model<T> model;
  std::vector<RayCena<T>> rays;
  std::vector<Hit<T>> hits;

  explicit Prepared(const Scene& scene) : model(scene, {}), rays(primary_rays(model, 96)) {
    std::shuffle(rays.begin(), rays.end(), std::mt19937_64(8));
    Classifier<T> classifier(model.solid);
    Boundary<T> boundary;
    for (const RayCena<T>& ray : rays) {
      classifier.begin(ray);
      if (classifier.next(boundary)) hits.push_back(hit_at(model, ray, boundary));
    }
  }
};

template <typename T>
void first_boundary(benchmark::State& state, const MadeScene& made) {
  const Prepared<T> prepared(made_scene(made));
  Classifier<T> classifier(prepared.model.solid);
  Boundary<T> boundary;
  std::size_t i = 0;
  for (auto _ : state) {
    classifier.begin(prepared.rays[i]);
    benchmark::DoNotOptimize(classifier.next(boundary));
    i = (i + 1) % prepared.rays.size();
  }
}

template <typename T>
void shadow_blocked(benchmark::State& state, const MadeScene& made) {
  const Prepared<T> prepared(made_scene(made));
  const PointLight<T>& light = prepared.model.lights[0];
  Classifier<T> classifier(prepared.model.solid);
  std::size_t i = 0;
  for (auto _ : state) {
    const Hit<T>& hit = prepared.hits[i];
    benchmark::DoNotOptimize(classifier.blocked({hit.point, light.position - hit.point},
                                                hit.leaving_on_eye_side(), light.clearance));
    i = (i + 1) % prepared.hits.size();
  }
}

template <typename T>
void shade_hit(benchmark::State& state, const Scene& scene) {
  const Prepared<T> prepared(scene);
  Classifier<T> classifier(prepared.model.solid);
  RayCounts counts;
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(shade(prepared.model, classifier, prepared.hits[i], counts));
    i = (i + 1) % prepared.hits.size();
  }
}

template <typename T>
void whole_pixel(benchmark::State& state, const Scene& scene, int depth) {
  TraceOptions options;
  options.depth_limit = depth;
  const Model<T> model(scene, options.possible_effects());
  Tracer<T> tracer(model, options);
  constexpr ImageSize kSize{160, 120};
  int pixel = 0;
  for (auto _ : state) {
    const auto ray = model.camera.primary_ray(pixel % kSize.width, pixel / kSize.width, kSize);
    benchmark::DoNotOptimize(tracer.pixel(ray));
    pixel = (pixel + 1) % (kSize.width * kSize.height);
  }
}

template <typename T>
void add_all(const std::string& type, const Scene& whitted) {
  const auto add = [&](const std::string& name, auto function, const auto&... given) {
    benchmark::RegisterBenchmark((name + "/" + type).c_str(),
                                 [=](benchmark::State& state) { function(state, given...); });
  };
  const char* kKinds[] = {"cube", "sphere", "cone", "cylinder"};
  for (int kind = 0; kind < 4; ++kind)
    add(std::string("intersect/") + kKinds[kind], intersect_primitive<T>,
        static_cast<PrimitiveKind>(kind));
  for (const int n : kSizes)
    for (const MadeScene& made :
         {MadeScene{.primitives = n}, MadeScene{.primitives = n, .chain = true},
          MadeScene{.primitives = n, .cut = MadeScene::Cut::root}}) {
      add("first/" + made.name(), first_boundary<T>, made);
      add("blocked/" + made.name(), shadow_blocked<T>, made);
    }
  add("shade/mixed-3000", shade_hit<T>, made_scene({.primitives = 3'000}));
  add("shade/whitted", shade_hit<T>, whitted);
  for (const int depth : {1, 2, 5})
    add("pixel/whitted/depth" + std::to_string(depth), whole_pixel<T>, whitted, depth);
}

}  // namespace

int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  const char* images = std::getenv("SIR_IMAGES");
  try {
    const Scene whitted = read_scene(std::filesystem::path(images ? images : "images") / "whitted");
    add_all<double>("double", whitted);
    add_all<float>("float", whitted);
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "part_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}

#else

int main() {
  std::printf("part_bench: built without Google Benchmark; Debian's package is libbenchmark-dev\n");
  return 0;
}

#endif
