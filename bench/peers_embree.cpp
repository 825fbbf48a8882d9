#include "bench/peers_embree.h"

#ifdef SIR_HAS_EMBREE
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <list>
#include <map>
#include <string>
#include <vector>

#include "bench/child.h"
#include "bench/first_hits.h"
#include "bench/scenes.h"

namespace sir::bench {
namespace {

constexpr int kSide = 512;

#ifdef SIR_HAS_EMBREE

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

  /// Whether packets of 16 are Embree's own here; else it takes them apart.
  bool has_packets_of_16() const {
    return rtcGetDeviceProperty(device_, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0;
  }

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

#endif

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

using Times = std::map<std::string, std::vector<double>>;  // ns a ray, round by round

// One size's spheres and rays, ready for all contenders.
class Group {
 public:
  explicit Group(int primitives)
      : scene_(made_scene({.primitives = primitives, .spheres = true})),
        in_double_(scene_, {}),
        in_float_(scene_, {}),
        rays_in_double_(primary_rays(in_double_, kSide)),
        rays_(primary_rays(in_float_, kSide)),
        primitives_(primitives) {}

  int primitives() const { return primitives_; }
  const Times& times() const { return times_; }
  void forget() { times_.clear(); }

  void run() {
    timed("ours, float", [&] { with_float_.find(rays_, t_["ours, float"]); });
    timed("ours, double", [&] { with_double_.find(rays_in_double_, t_in_double_); });
#ifdef SIR_HAS_EMBREE
    const auto embree = [&](const char* name, const auto& work) {
      timed(name, [&] { work(spheres_, rays_, t_[name]); });
    };
    embree("Intersect16", intersect_packets<RTCRayHit16, 16, rtcIntersect16>);
    embree("Intersect8", intersect_packets<RTCRayHit8, 8, rtcIntersect8>);
    embree("Intersect1", intersect_1);
#endif
  }

  void tell(SpeedTable& table) const {
    const std::string n = " " + std::to_string(primitives_);
    for (const auto& [name, ns] : times_) table.line(name + n, "ns a ray", Quartiles(ns));
#ifdef SIR_HAS_EMBREE
    if (!spheres_.has_packets_of_16())
      std::printf("  Embree has no packets of 16 of its own here.\n");
    for (const char* own : {"ours, double", "ours, float"})
      for (const char* other : {"Intersect16", "Intersect8", "Intersect1"})
        table.line(own + n, std::string("speed over that of ") + other,
                   Quartiles(ratios(times_.at(other), times_.at(own))),
                   std::string(other) == "Intersect16" ? Demand{1, 2} : Demand{});
#endif
  }

  // What packets are not sure of costs much more.
  void tell_doubts() const {
    const auto share = [](const RayCounts& counts) {
      return 100 * double(counts.doubtful) / (double(counts.packets) * kPacketLanes);
    };
    std::printf("  left in doubt by our packets: %.2f %% of the rays in double, %.2f %% in float\n",
                share(with_double_.counts()), share(with_float_.counts()));
  }

  // Spheres in float and grazing rays: one just misses an edge here and there.
  bool same_hits() const {
    bool same = true;
    for (const auto& [name, t] : t_) {
      const std::size_t differ = differing(t_in_double_, t);
      std::printf("  %s: %zu of %zu rays differ from ours in double\n", name.c_str(), differ,
                  rays_.size());
      same = same && differ <= rays_.size() / 500;
    }
    if (!same) std::printf("  NOT THE SAME HITS\n");
    return same;
  }

 private:
  template <typename Work>
  void timed(const std::string& name, const Work& work) {
    const double start = own_cpu_seconds();
    work();
    times_[name].push_back((own_cpu_seconds() - start) * 1e9 / double(rays_.size()));
  }

  Scene scene_;
  Model<double> in_double_;
  Model<float> in_float_;
  std::vector<RayCena<double>> rays_in_double_;
  std::vector<RayCena<float>> rays_;
  int primitives_;
  FirstHits<double> with_double_{in_double_};
  FirstHits<float> with_float_{in_float_};
#ifdef SIR_HAS_EMBREE
  Spheres spheres_{scene_};
#endif
  Times times_;
  std::map<std::string, std::vector<float>> t_;
  std::vector<double> t_in_double_;
};

void tell_growth(const Group& small, const Group& large, SpeedTable& table) {
  for (const auto& [name, ns] : small.times()) {
    std::vector<double> exponents = ratios(large.times().at(name), ns);
    for (double& value : exponents)
      value = std::log(value) / std::log(double(large.primitives()) / small.primitives());
    table.line("exponent, " + name, "300 to 30,000", Quartiles(exponents));
  }
}

}  // namespace

bool measure_embree(int rounds, SpeedTable& table) {
  table.begin("spheres: nearest hits of 512x512 primary rays, one thread, CPU time");
#ifndef SIR_HAS_EMBREE
  std::printf("Built without Embree 3: ours alone. Debian's package is libembree-dev.\n");
#endif
  // Groups do not move: what finds hits keeps the address of its model.
  std::list<Group> groups;
  for (const int primitives : kSizes) groups.emplace_back(primitives);
  for (int round = -1; round < rounds; ++round)
    for (Group& group : groups) {
      if (round == 0) group.forget();  // the first was for the caches
      group.run();
    }
  bool same = true;
  for (const Group& group : groups) {
    group.tell(table);
    group.tell_doubts();
    same = group.same_hits() && same;
  }
  tell_growth(groups.front(), groups.back(), table);
  return same;
}

}  // namespace sir::bench
