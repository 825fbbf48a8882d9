// What do packets of sixteen rays save against one ray at a time? Primary rays and
// shadow rays to the first light, one thread. Usage: packet_bench [WIDTH [SCENE]]
// Runs are paired and interleaved; exit code 1 where the answers differ.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <hwy/highway.h>

#include "bench/timing.h"
#include "tests/packet_scenes.h"
#include "tracer/hit.h"
#include "tracer/packet_blocked.h"
#include "tracer/packet_first.h"
#include "tracer/scene_file.h"

namespace {

using namespace sir;
using sir::bench::median;
using sir::bench::milliseconds;

const int kPairs = sir::bench::rounds(7);

void look_at(Scene& scene) {
  scene.camera = {{4.4, 4.4}, {0, 0, 0}, {0.2, -0.3, -1}, 8, {0, 1, 0}, false, 8, false};
  scene.lighting.lights = {{{7, 9, 8}, glm::dvec3(1)}};
}

Scene spheres(int n) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-2, 2);
  test::SceneBuilder build;
  test::SceneBuilder::Id root = 0;
  for (int i = 0; i < n; ++i) {
    const double radius = (1.2 + 0.3 * std::abs(any(random))) * std::cbrt(1.0 / n);
    const auto one = build.sphere({any(random), any(random), any(random)}, radius);
    root = i == 0 ? one : build.combine(Operation::union_of, root, one);
  }
  Scene scene = build.finish(root);
  look_at(scene);
  return scene;
}

Scene parts(int n) {
  Scene scene = test::union_of_parts(3, n, 2.5 * std::cbrt(1.0 / n), false);
  look_at(scene);
  return scene;
}

// Rays in blocks of 4x4 pixels, and those of the primary ones that hit something,
// on to the light.
template <typename T>
struct Rays {
  std::vector<RayPacket<T>> primary, shadow;
  std::size_t primary_count = 0, shadow_count = 0;
};

template <typename T>
Rays<T> make_rays(const Model<T>& model, int width) {
  Rays<T> rays;
  const ImageSize size{width, width * 3 / 4};
  Classifier<T> classifier(model.solid);
  RayPacket<T> shadow;
  for (int j = 0; j + 3 < size.height; j += 4)
    for (int i = 0; i + 3 < size.width; i += 4) {
      RayPacket<T> primary;
      for (int k = 0; k < 16; ++k) {
        const auto lane = static_cast<std::size_t>(k);
        const RayCena<T> ray = model.camera.primary_ray(i + k % 4, j + k / 4, size);
        primary.set(lane, ray);
        ++rays.primary_count;
        classifier.begin(ray);
        Boundary<T> boundary;
        if (!classifier.next(boundary)) continue;
        const Hit<T> hit = hit_at(model, ray, boundary);
        const auto to_light = model.lights[0].position - hit.point;
        if (!(dot(hit.normal, to_light) > 0)) continue;
        shadow.set(rays.shadow_count++ % kPacketLanes, {hit.point, to_light},
                   hit.leaving_on_eye_side());
        if (rays.shadow_count % kPacketLanes > 0) continue;
        rays.shadow.push_back(shadow);
        shadow.active = 0;
      }
      rays.primary.push_back(primary);
    }
  if (shadow.active) rays.shadow.push_back(shadow);
  return rays;
}

struct Figures {
  double packets = 0, single = 0;  // nanoseconds a ray
  double doubtful = 0;             // share
  std::size_t differing = 0;
};

void print(const char* what, const Figures& f) {
  std::printf("  %-8s %7.1f ns a ray, one by one %7.1f ns: %5.2f times; doubtful %.3f %%%s\n", what,
              f.packets, f.single, f.single / f.packets, 100 * f.doubtful,
              f.differing ? "  ANSWERS DIFFER" : "");
}

template <typename T>
Figures measure_primary(const Solid<T>& solid, const PacketSolid<T>& packets, const Rays<T>& rays) {
  Figures figures;
  std::vector<double> together, single;
  Classifier<T> classifier(solid);
  for (int run = 0; run < kPairs; ++run) {
    std::vector<PacketFirst<T>> found(rays.primary.size());
    together.push_back(milliseconds([&] {
      for (std::size_t p = 0; p < rays.primary.size(); ++p)
        found[p] = first_boundaries(packets, rays.primary[p]);
    }));
    std::vector<Boundary<T>> expected(rays.primary.size() * kPacketLanes);
    std::vector<char> met(expected.size());
    single.push_back(milliseconds([&] {
      for (std::size_t p = 0; p < rays.primary.size(); ++p)
        for (std::size_t lane = 0; lane < kPacketLanes; ++lane) {
          met[p * kPacketLanes + lane] =
              classifier.first(rays.primary[p].ray(lane), {}, expected[p * kPacketLanes + lane]);
        }
    }));
    figures.doubtful = 0;
    for (std::size_t p = 0; p < rays.primary.size(); ++p)
      for (std::size_t lane = 0; lane < kPacketLanes; ++lane) {
        const Boundary<T>&a = found[p].boundary[lane], &b = expected[p * kPacketLanes + lane];
        const bool hit = found[p].hit >> lane & 1u;
        if (found[p].doubtful >> lane & 1u) ++figures.doubtful;
        else if (hit != bool(met[p * kPacketLanes + lane]) ||
                 (hit && (a.leaf != b.leaf || a.face != b.face || a.entering != b.entering ||
                          a.t != b.t || a.error != b.error)))
          ++figures.differing;
      }
  }
  const double count = double(rays.primary_count);
  figures.doubtful /= count;
  figures.packets = median(together) * 1e6 / count;
  figures.single = median(single) * 1e6 / count;
  return figures;
}

template <typename T>
Figures measure_shadow(const Model<T>& model, const PacketSolid<T>& packets, const Rays<T>& rays) {
  Figures figures;
  std::vector<double> together, single;
  Classifier<T> classifier(model.solid);
  const T clear = model.lights[0].clearance;
  for (int run = 0; run < kPairs; ++run) {
    std::vector<PacketBlocked> found(rays.shadow.size());
    together.push_back(milliseconds([&] {
      for (std::size_t p = 0; p < rays.shadow.size(); ++p)
        found[p] = find_blocked(packets, rays.shadow[p], clear);
    }));
    std::vector<std::uint32_t> expected(rays.shadow.size());
    single.push_back(milliseconds([&] {
      for (std::size_t p = 0; p < rays.shadow.size(); ++p)
        for (std::size_t lane = 0; lane < kPacketLanes; ++lane)
          if (rays.shadow[p].active >> lane & 1u)
            expected[p] |= std::uint32_t{classifier.blocked(rays.shadow[p].ray(lane),
                                                            rays.shadow[p].start(lane), clear)}
                           << lane;
    }));
    figures.doubtful = 0;
    for (std::size_t p = 0; p < rays.shadow.size(); ++p) {
      figures.doubtful += __builtin_popcount(found[p].doubtful);
      if ((found[p].blocked ^ expected[p]) & ~found[p].doubtful) ++figures.differing;
    }
  }
  const double count = double(rays.shadow_count);
  figures.doubtful /= count;
  figures.packets = median(together) * 1e6 / count;
  figures.single = median(single) * 1e6 / count;
  return figures;
}

template <typename T>
bool measure(const Scene& scene, const char* name, const char* type, int width) {
  const Model<T> model(scene, {});
  const PacketSolid<T> packets(model.solid);
  const Rays<T> rays = make_rays(model, width);
  std::printf("%s, %s, %zu primitives, %zu parts, %zu + %zu rays\n", name, type,
              model.solid.leaves.size(), packets.parts.size(), rays.primary_count,
              rays.shadow_count);
  const Figures primary = measure_primary(model.solid, packets, rays);
  print("primary", primary);
  const Figures shadow = measure_shadow(model, packets, rays);
  print("shadow", shadow);
  return primary.differing + shadow.differing == 0;
}

}  // namespace

int main(int argc, char** argv) {
  const int width = argc > 1 ? std::atoi(argv[1]) : 320;
  if (width < 4) {
    std::fprintf(stderr, "usage: packet_bench [WIDTH [SCENE]]\n");
    return 2;
  }
  bool equal = true;
  const auto both = [&](const Scene& scene, const char* name) {
    if (argc > 2 && std::string(name) != argv[2]) return;
    equal &= measure<double>(scene, name, "double", width);
    equal &= measure<float>(scene, name, "float", width);
  };
  std::printf("best of this machine: %s\n",
              hwy::TargetName(hwy::SupportedAndGeneratedTargets().front()));
  for (const char* name : {"whitted", "calice"})
    both(read_scene(std::string(SIR_IMAGES "/") + name), name);
  both(spheres(300), "spheres300");
  both(spheres(3000), "spheres3000");
  both(parts(300), "parts300");
  return equal ? 0 : 1;
}
