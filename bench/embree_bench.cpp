// Nearest hits of primary rays on unions of spheres, against Embree 3: one thread, 500x500 rays
// in the order of the rows, by Intersect1, 8 and 16 and by our Classifier in float and double.
// Usage: embree_bench [ROUNDS]
// Contenders take turns; printed are medians of ns a ray, and the median of the rounds' ratios
// to ours. The hits are compared first: exit code 1 where they are not the same. Built without
// Embree it only says which package it wants.
#include <cstdio>

#ifdef SIR_HAS_EMBREE

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "bench/child.h"
#include "bench/first_hits.h"
#include "bench/scenes.h"
#include "bench/speed_table.h"

namespace {

using namespace sir;
using namespace sir::bench;

constexpr int kSide = 500;

// A union of spheres as Embree's own sphere points.
class Spheres {
 public:
  explicit Spheres(const Scene& scene)
      : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    std::vector<CsgNode> primitives;
    for (const CsgNode& node : scene.tree.nodes)
      if (!node.composite) primitives.push_back(node);
    auto* out = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                            RTC_FORMAT_FLOAT4, 4 * sizeof(float),
                                                            primitives.size()));
    for (const CsgNode& node : primitives) {
      for (int axis = 0; axis < 3; ++axis)
        *out++ = static_cast<float>(node.placement.translation[axis]);
      *out++ = static_cast<float>(node.placement.linear[0].x);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    rtcCommitScene(scene_);
  }
  ~Spheres() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Spheres(const Spheres&) = delete;
  Spheres& operator=(const Spheres&) = delete;

  RTCScene get() const { return scene_; }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

RTCIntersectContext coherent_context() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

void intersect_1(const Spheres& spheres, const std::vector<RayCena<float>>& rays,
                 std::vector<float>& t) {
  RTCIntersectContext context = coherent_context();
  t.resize(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto &o = rays[i].origin.v, &d = rays[i].direction.v;
    RTCRayHit query{};
    RTCRay& ray = query.ray;
    ray.org_x = o.x, ray.org_y = o.y, ray.org_z = o.z;
    ray.dir_x = d.x, ray.dir_y = d.y, ray.dir_z = d.z;
    ray.tfar = kNothing<float>;
    ray.mask = ~0u;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(spheres.get(), &context, &query);
    t[i] = ray.tfar;
  }
}

// The filling of the packet is part of the time, as a tracer would have to do it.
template <typename Packet, int N, auto Intersect>
void intersect_packets(const Spheres& spheres, const std::vector<RayCena<float>>& rays,
                       std::vector<float>& t) {
  RTCIntersectContext context = coherent_context();
  t.resize(rays.size());
  Packet query{};
  alignas(64) int valid[N];
  for (std::size_t first = 0; first < rays.size(); first += N) {
    const auto count = std::min<std::size_t>(N, rays.size() - first);
    for (std::size_t k = 0; k < N; ++k) {
      valid[k] = k < count ? -1 : 0;
      const RayCena<float>& given = rays[first + std::min(k, count - 1)];
      const auto &o = given.origin.v, &d = given.direction.v;
      auto& ray = query.ray;
      ray.org_x[k] = o.x, ray.org_y[k] = o.y, ray.org_z[k] = o.z;
      ray.dir_x[k] = d.x, ray.dir_y[k] = d.y, ray.dir_z[k] = d.z;
      ray.tnear[k] = 0;
      ray.tfar[k] = kNothing<float>;
      ray.mask[k] = ~0u;
      query.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    }
    Intersect(valid, spheres.get(), &context, &query);
    for (std::size_t k = 0; k < count; ++k) t[first + k] = query.ray.tfar[k];
  }
}

// Rays on which one meets something and the other not, or not in the same place.
template <typename A, typename B>
std::size_t differing(const std::vector<A>& a, const std::vector<B>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = double(a[i]), y = double(b[i]);
    if (std::isinf(x) != std::isinf(y) || (!std::isinf(x) && std::abs(x - y) > 1e-3 * std::abs(x)))
      ++count;
  }
  return count;
}

bool compare(int primitives, int rounds, SpeedTable& table) {
  const Scene scene = made_scene({.primitives = primitives, .spheres = true});
  const Model<double> in_double(scene, {});
  const Model<float> in_float(scene, {});
  const Spheres spheres(scene);
  const auto rays = primary_rays(in_float, kSide);
  const auto rays_in_double = primary_rays(in_double, kSide);
  Classifier<float> with_float(in_float.solid);
  Classifier<double> with_double(in_double.solid);
  std::vector<float> one, eight, sixteen, ours;
  std::vector<double> ours_in_double;
  std::map<std::string, std::vector<double>> ns;
  const auto timed = [&](const std::string& name, const auto& work) {
    const double start = own_cpu_seconds();
    work();
    ns[name].push_back((own_cpu_seconds() - start) * 1e9 / double(rays.size()));
  };
  for (int round = -1; round < rounds; ++round) {
    if (round == 0) ns.clear();  // the first was for the caches
    timed("Intersect1", [&] { intersect_1(spheres, rays, one); });
    timed("ours, float", [&] { find_first_hits(with_float, rays, ours); });
    timed("Intersect8",
          [&] { intersect_packets<RTCRayHit8, 8, rtcIntersect8>(spheres, rays, eight); });
    timed("ours, double", [&] { find_first_hits(with_double, rays_in_double, ours_in_double); });
    timed("Intersect16",
          [&] { intersect_packets<RTCRayHit16, 16, rtcIntersect16>(spheres, rays, sixteen); });
  }
  table.begin(std::to_string(primitives) + " spheres: ns a ray; speed is Embree's time / ours");
  for (const auto& [name, values] : ns) table.line(name, "ns", Quartiles(values));
  for (const char* own : {"ours, float", "ours, double"})
    for (const char* embree : {"Intersect1", "Intersect8", "Intersect16"})
      table.line(std::string(own) + ", speed", std::string("of ") + embree,
                 Quartiles(ratios(ns[embree], ns[own])));
  // Embree's spheres are in float, and grazing rays pass them by or not.
  const std::size_t most = rays.size() / 500;
  bool same = true;
  const auto check = [&](const char* name, std::size_t count) {
    std::printf("  %s: %zu of %zu rays differ from ours in double\n", name, count, rays.size());
    same = same && count <= most;
  };
  check("Intersect1", differing(ours_in_double, one));
  check("Intersect8", differing(ours_in_double, eight));
  check("Intersect16", differing(ours_in_double, sixteen));
  check("ours, float", differing(ours_in_double, ours));
  return same;
}

}  // namespace

int main(int count, char** arguments) {
  const int rounds = count > 1 ? std::atoi(arguments[1]) : 7;
  if (count > 2 || rounds < 1) {
    std::fprintf(stderr, "usage: embree_bench [ROUNDS]\n");
    return 2;
  }
  SpeedTable table;
  bool same = true;
  for (const int primitives : kSizes) same = compare(primitives, rounds, table) && same;
  if (!same) std::printf("NOT THE SAME HITS\n");
  return same ? 0 : 1;
}

#else

int main() {
  std::printf("embree_bench: built without Embree 3; Debian's package is libembree-dev\n");
  return 0;
}

#endif
