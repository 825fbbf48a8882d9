#include "tracer/hesitation.h"

#include <algorithm>
#include <memory>
#include <mutex>

#include "tracer/camera.h"
#include "tracer/classify.h"
#include "tracer/recentre.h"

namespace sir {
namespace {

// What a list is compared by.
struct Named {
  std::int64_t node;
  std::uint8_t face;
  bool entering;
  friend auto operator<=>(const Named&, const Named&) = default;
};
using Names = std::vector<Named>;

// A scene in one scalar type.
template <typename T>
struct Sight {
  Solid<T> solid;
  Camera<T> camera;

  Sight(const Scene& scene, Precision precision)
      : Sight(Recentred(scene, offset_for(scene, precision))) {}
  explicit Sight(const Scene& scene) : solid(build_solid<T>(scene)), camera(scene.camera) {}
};

template <typename T>
class Lister {
 public:
  explicit Lister(const Sight<T>& sight, Fusing fusing = {})
      : sight_(sight), classifier_(sight.solid, Engine::gates, fusing) {}

  const Names& at(int i, int j, ImageSize size) {
    names_.clear();
    classifier_.begin(sight_.camera.primary_ray(i, j, size));
    Boundary<T> boundary;
    while (classifier_.next(boundary))
      names_.push_back({sight_.solid.leaves[boundary.leaf].node, boundary.face, boundary.entering});
    return names_;
  }

 private:
  const Sight<T>& sight_;
  Classifier<T> classifier_;
  Names names_;
};

// Adds the nodes in which two lists differ; those of all places where they hold
// the same in another order.
void add_difference(Names a, Names b, std::vector<std::int64_t>& nodes) {
  std::vector<Named> changed;
  const Names in_order_a = a, in_order_b = b;
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(),
                                std::back_inserter(changed));
  if (changed.empty())
    for (std::size_t i = 0; i < in_order_a.size(); ++i)
      if (in_order_a[i] != in_order_b[i]) changed.push_back(in_order_a[i]);
  for (const Named& name : changed) nodes.push_back(name.node);
}

class Searcher {
 public:
  Searcher(const Sight<double>& usual, const Sight<float>& coarse)
      : usual_(usual),
        coarse_(coarse),
        swollen_(usual, Fusing{false, 1}),
        shrunk_(usual, Fusing{false, -1}) {}

  std::uint8_t causes(int i, int j, ImageSize size, HesitationMap& map) {
    const Names& names = usual_.at(i, j, size);
    std::uint8_t causes = 0;
    if (compare(names, coarse_.at(i, j, size), map, &HesitationMap::Count::precision))
      causes |= kPrecision;
    nodes_.clear();
    for (Lister<double>* moved : {&swollen_, &shrunk_}) {
      const Names& other = moved->at(i, j, size);
      if (other != names) add_difference(names, other, nodes_);
    }
    if (count(map, &HesitationMap::Count::rounding)) causes |= kRounding;
    return causes;
  }

 private:
  bool compare(const Names& a, const Names& b, HesitationMap& map,
               std::uint64_t HesitationMap::Count::*counter) {
    nodes_.clear();
    if (a != b) add_difference(a, b, nodes_);
    return count(map, counter);
  }

  bool count(HesitationMap& map, std::uint64_t HesitationMap::Count::*counter) {
    if (nodes_.empty()) return false;
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    for (const std::int64_t node : nodes_) ++(map.nodes[node].*counter);
    ++(map.pixels.*counter);
    return true;
  }

  Lister<double> usual_;
  Lister<float> coarse_;
  Lister<double> swollen_, shrunk_;
  std::vector<std::int64_t> nodes_;
};

}  // namespace

HesitationMap find_hesitation(const Scene& scene, const RenderOptions& options,
                              const std::function<void(double)>& progress, std::stop_token stop) {
  const Region region = region_or_all(options.region, options.size);
  const Sight<double> usual(scene, Precision::double_);
  const Sight<float> coarse(scene, Precision::float_);
  HesitationMap result;
  result.size = {region.width, region.height};
  result.causes.resize(result.size.pixels());
  std::mutex merge;
  const auto make_worker = [&]() -> TileWorker {
    return [&, searcher = std::make_shared<Searcher>(usual, coarse)](const Region& tile) {
      HesitationMap found;
      for (int j = tile.y; j < tile.y + tile.height && !stop.stop_requested(); ++j)
        for (int i = tile.x; i < tile.x + tile.width; ++i)
          result.causes[static_cast<std::size_t>(j) * static_cast<std::size_t>(region.width) +
                        static_cast<std::size_t>(i)] =
              searcher->causes(region.x + i, region.y + j, options.size, found);
      const std::scoped_lock lock(merge);
      result.pixels.precision += found.pixels.precision;
      result.pixels.rounding += found.pixels.rounding;
      for (const auto& [node, count] : found.nodes) {
        result.nodes[node].precision += count.precision;
        result.nodes[node].rounding += count.rounding;
      }
    };
  };
  result.complete = for_each_tile(result.size, options.threads, make_worker, progress, stop);
  return result;
}

Planes marked(const Planes& image, const HesitationMap& map) {
  constexpr Rgb8 kMarks[] = {{}, {255, 48, 48}, {64, 128, 255}, {255, 224, 32}};
  Planes result(image.size);
  for (std::size_t p = 0; p < image.size.pixels(); ++p) {
    const Rgb8 seen = image.at(p);
    // A third of the luma (Rec. 601), so that marks stand out.
    const auto grey =
        static_cast<std::uint8_t>((299 * seen.r + 587 * seen.g + 114 * seen.b) / 3000);
    result.set(p, map.causes[p] ? kMarks[map.causes[p]] : Rgb8{grey, grey, grey});
  }
  return result;
}

}  // namespace sir
