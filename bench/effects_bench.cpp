// Does an effect that a scene does not call for cost anything? What does it save to cast only
// the rays that matter? Usage: effects_bench [BASE...]; without scenes, made-up ones.
// Times are of the processor, one thread. Runs are interleaved; a ratio is the median of each
// round's, its quartiles in brackets. Exit code 1 where two images differ that must not.
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "bench/timing.h"
#include "tests/scene_builder.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"
#include "tracer/trace.h"

namespace {

using namespace sir;

const int kRounds = sir::bench::rounds(15);

template <typename Work>
double processor_ms(Work work) {
  const std::clock_t start = std::clock();
  work();
  return 1e3 * double(std::clock() - start) / CLOCKS_PER_SEC;
}

// The median of `a[i] / b[i]` and its quartiles, as text.
std::string ratio(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
  std::sort(ratios.begin(), ratios.end());
  char text[64];
  std::snprintf(text, sizeof text, "%6.3f (%.3f..%.3f)", ratios[ratios.size() / 2],
                ratios[ratios.size() / 4], ratios[ratios.size() * 3 / 4]);
  return text;
}

struct Named {
  std::string name;
  Scene scene;
};

// The same shapes without mirrors and glass.
Scene matte(Scene scene) {
  for (Surface& surface : scene.surfaces)
    for (Coefficients* k : {&surface.first, &surface.second}) k->specular = k->transmission = 0;
  return scene;
}

RenderOptions options_for(bool exhaustive) {
  RenderOptions options;
  options.size = {320, 240};
  options.threads = 1;
  options.trace.allowed_effects.exhaustive = exhaustive;
  return options;
}

// auto against the secondary effects forbidden by name, and all against auto.
bool compare_renders(const Named& named) {
  RenderOptions needed = options_for(false), forbidden = needed;
  EffectSet& allowed = forbidden.trace.allowed_effects;
  allowed.filter = allowed.reflection = allowed.refraction = allowed.highlight = false;
  const bool is_matte = !effects_called_for(named.scene, {}).reflection;
  std::vector<double> auto_ms, forbidden_ms, all_ms;
  Planes with_auto, with_forbidden, with_all;
  const auto timed = [&](const RenderOptions& options, std::vector<double>& ms, Planes& planes) {
    ms.push_back(processor_ms([&] { planes = render(named.scene, options).planes; }));
  };
  for (int round = 0; round < kRounds; ++round) {
    timed(needed, auto_ms, with_auto);
    if (is_matte) timed(forbidden, forbidden_ms, with_forbidden);
    if (round % 5 == 0) timed(options_for(true), all_ms, with_all);
  }
  std::vector<double> paired;
  for (int round = 0; round < kRounds; round += 5)
    paired.push_back(auto_ms[static_cast<std::size_t>(round)]);
  std::printf("%-22s %8.1f ms   auto/forbidden %-24s all/auto %s\n", named.name.c_str(),
              bench::median(auto_ms), is_matte ? ratio(auto_ms, forbidden_ms).c_str() : "-",
              ratio(all_ms, paired).c_str());
  return with_auto == with_all && (!is_matte || with_auto == with_forbidden);
}

// Pixels with the rays spared that cannot change them, against all rays of the effects.
bool compare_sparing(const Named& named) {
  const Model<double> model(named.scene, {});
  const ImageSize size{320, 240};
  std::vector<double> spared_ms, every_ms;
  std::vector<Rgb8> sparing(size.pixels()), every(size.pixels());
  std::uint64_t spared = 0;
  for (int round = 0; round < kRounds; ++round) {
    Tracer<double> one(model, {}), other(model, {});
    const auto pass = [&](const auto& pixel, std::vector<Rgb8>& pixels) {
      for (int j = 0; j < size.height; ++j)
        for (int i = 0; i < size.width; ++i)
          pixels[static_cast<std::size_t>(j * size.width + i)] =
              pixel(model.camera.primary_ray(i, j, size));
    };
    spared_ms.push_back(processor_ms(
        [&] { pass([&](const RayCena<double>& ray) { return one.pixel(ray); }, sparing); }));
    every_ms.push_back(processor_ms([&] {
      pass([&](const RayCena<double>& ray) { return to_rgb8(other.radiance(ray)); }, every);
    }));
    spared = one.counts().spared;
  }
  std::printf("%-22s sparing/not %s   %llu rays spared\n", named.name.c_str(),
              ratio(spared_ms, every_ms).c_str(), static_cast<unsigned long long>(spared));
  return sparing == every;
}

// Shadow rays asked whether anything is in their way, against the ordered list.
bool compare_blocked(const Named& named) {
  const Model<double> model(named.scene, {});
  if (model.lights.empty()) return true;
  Classifier<double> classifier(model.solid);
  struct Shadow {
    RayCena<double> ray;
    RayStart<double> start;
    double clearance;
  };
  std::vector<Shadow> shadows;
  const ImageSize size{160, 120};
  for (int j = 0; j < size.height; ++j)
    for (int i = 0; i < size.width; ++i) {
      const auto ray = model.camera.primary_ray(i, j, size);
      classifier.begin(ray);
      Boundary<double> boundary;
      if (!classifier.next(boundary)) continue;
      const auto hit = hit_at(model, ray, boundary);
      for (const auto& light : model.lights) {
        const auto to_light = light.position - hit.point;
        if (dot(hit.normal, to_light) > 0)
          shadows.push_back({{hit.point, to_light}, hit.leaving_on_eye_side(), light.clearance});
      }
    }
  std::vector<double> asked_ms, ordered_ms;
  std::vector<bool> asked(shadows.size()), ordered(shadows.size());
  for (int round = 0; round < kRounds; ++round) {
    asked_ms.push_back(processor_ms([&] {
      for (std::size_t i = 0; i < shadows.size(); ++i)
        asked[i] = classifier.blocked(shadows[i].ray, shadows[i].start, shadows[i].clearance);
    }));
    ordered_ms.push_back(processor_ms([&] {
      for (std::size_t i = 0; i < shadows.size(); ++i) {
        classifier.begin(shadows[i].ray, shadows[i].start, 1);
        Boundary<double> first;
        ordered[i] =
            classifier.next(first) && first.t < 1 && !Numeric<double>::same_event(first.t, 1);
      }
    }));
  }
  std::printf("%-22s asked/ordered %s   %zu shadow rays\n", named.name.c_str(),
              ratio(asked_ms, ordered_ms).c_str(), shadows.size());
  return asked == ordered;
}

// Balls, and cubes with a ball cut out, on a mirroring floor; some of glass.
Named on_a_floor(int solids) {
  test::SceneBuilder build;
  std::mt19937_64 random(1989);
  std::uniform_real_distribution<double> place(-4, 4), size(0.2, 0.5);
  build.scene.lighting = {{0.2, 0.3, 0.5},
                          glm::dvec3(0.3),
                          {{{5, 9, 6}, glm::dvec3(0.7)}, {{-6, 7, 3}, glm::dvec3(0.4)}}};
  auto root = build.cube({-5, -1, -5}, {5, 0, 5}, 1);
  for (int n = 0; n < solids; ++n) {
    const glm::dvec3 at(place(random), size(random) + 0.3, place(random));
    const double r = size(random);
    auto solid = build.sphere(at, r, 2 + n % 2);
    if (n % 3 == 0)
      solid =
          build.combine(Operation::difference, build.cube(at - r * 0.8, at + r * 0.8, 2), solid);
    root = build.combine(Operation::union_of, root, solid);
  }
  for (const std::int64_t number : {1, 2, 3}) {
    Coefficients& k = build.surface(number).first;
    k.ambient = k.diffuse = glm::dvec3(0.2 * double(number), 0.5, 0.3);
    k.specular = 0.15 * double(number);
    k.exponent = 30;
  }
  build.surface(3).first.transmission = 0.4;
  build.surface(3).first.index = 1.3;
  Scene scene = build.finish(root);
  scene.camera = {{4, 3}, {0, 0.5, 0}, {0, -0.6, -1}, 9, {0, 1, 0}, false, 6, false};
  return {"made up, " + std::to_string(solids), scene};
}

std::vector<Named> made_up() { return {on_a_floor(12), on_a_floor(60)}; }

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  std::vector<Named> scenes;
  for (int i = 1; i < argc; ++i) scenes.push_back({argv[i], read_scene(argv[i])});
  if (scenes.empty()) scenes = made_up();
  bool equal = true;
  for (const Named& named : scenes) {
    equal = compare_renders({named.name + " matte", matte(named.scene)}) && equal;
    equal = compare_renders(named) && equal;
    equal = compare_sparing(named) && equal;
    equal = compare_blocked({named.name + " matte", matte(named.scene)}) && equal;
  }
  std::printf(equal ? "All images are equal.\n" : "IMAGES DIFFER.\n");
  return equal ? 0 : 1;
}
