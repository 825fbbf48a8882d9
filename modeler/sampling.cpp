#include "modeler/sampling.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modeler/step.h"
#include "modeler/view.h"
#include "tracer/probe.h"

namespace sir::modeler {
namespace {

constexpr std::size_t kGroups = 12;  // four along each axis, for an estimate of the error
constexpr std::size_t kRaysForEmptiness = 1536;
constexpr std::size_t kMostNodes = 300'000;  // built in all for one solid's empty parts

// Points of the unit square spread evenly: multiples of the powers of the plastic number
// (Roberts's R2 sequence), shifted from group to group.
glm::dvec2 spread(std::size_t i) {
  constexpr double kPlastic = 1.32471795724474602596;
  const double n = static_cast<double>(i) + 0.5;
  return {std::fmod(n / kPlastic, 1.0), std::fmod(n / (kPlastic * kPlastic), 1.0)};
}

// Which nodes a point is inside of.
std::vector<char> inside(const std::vector<const Node*>& nodes, const glm::dvec3& point) {
  std::vector<char> in(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (const Composite* composite = nodes[i]->composite()) {
      const bool left = in[i + 1] != 0, right = in[i + 1 + composite->left->count] != 0;
      switch (composite->operation) {
        case Operation::union_of: in[i] = left || right; break;
        case Operation::difference: in[i] = left && !right; break;
        case Operation::intersection: in[i] = left && right; break;
      }
      continue;
    }
    const Primitive& primitive = *nodes[i]->primitive();
    const Placement back = inverse_of(primitive.local_cena);
    const glm::dvec3 p = back.linear * (point - primitive.local_cena.translation);
    const double across = p.x * p.x + p.z * p.z;
    switch (primitive.kind) {
      case PrimitiveKind::cube:
        in[i] = p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1 && p.z > 0 && p.z < 1;
        break;
      case PrimitiveKind::sphere: in[i] = across + p.y * p.y < 1; break;
      case PrimitiveKind::cone: in[i] = p.y > 0 && p.y < 1 && across < (1 - p.y) * (1 - p.y); break;
      case PrimitiveKind::cylinder: in[i] = p.y > 0 && p.y < 1 && across < 1; break;
    }
  }
  return in;
}

}  // namespace

Sampling sample(const Node& tree, std::size_t rays, std::stop_token stop) {
  Sampling result;
  const Box& box = tree.bounds;
  const glm::dvec3 extent = box.high - box.low;
  if (is_empty(box) || !(extent.x > 0 && extent.y > 0 && extent.z > 0) ||
      !std::isfinite(extent.x + extent.y + extent.z))
    return result;
  const auto prober = make_prober(scene_of(tree, framing(box, 1)), Precision::double_);
  const std::size_t per_group = std::max<std::size_t>(rays / kGroups, 1);
  double longest = 0;
  std::array<double, kGroups> volumes{};
  for (std::size_t group = 0; group < kGroups; ++group) {
    const int axis = static_cast<int>(group % 3), u = (axis + 1) % 3, v = (axis + 2) % 3;
    double length = 0;
    for (std::size_t i = 0; i < per_group; ++i) {
      if (stop.stop_requested()) return result;
      const glm::dvec2 at = spread(group * per_group + i);
      glm::dvec3 origin = box.low, direction(0);
      origin[u] += at.x * extent[u];
      origin[v] += at.y * extent[v];
      origin[axis] -= 0.5 * extent[axis];  // well outside
      direction[axis] = extent[axis];
      double entered = 0;
      for (const ProbeHit& hit : prober->hits(origin, direction)) {
        const glm::dvec3 point = origin + hit.t * direction;
        result.met.include({point, point});
        if (hit.entering) {
          entered = hit.t;
          continue;
        }
        length += hit.t - entered;
        if (hit.t - entered > longest) {
          longest = hit.t - entered;
          result.inside = origin + (entered / 2 + hit.t / 2) * direction;
        }
      }
    }
    volumes[group] = length / static_cast<double>(per_group) * extent.x * extent.y * extent.z;
  }
  for (const double volume : volumes) result.volume += volume / kGroups;
  double square = 0;
  for (const double volume : volumes) square += (volume - result.volume) * (volume - result.volume);
  result.error = 2 * std::sqrt(square / (kGroups * (kGroups - 1)));
  result.rays = kGroups * per_group;
  return result;
}

Box filled_box(const Node& tree, std::stop_token stop) {
  constexpr std::size_t kRays = 12 * 512, kMostTests = 20'000'000;  // primitives times rays
  bool takes_away = false;
  for (const Node* node : preorder(tree))
    if (const Composite* composite = node->composite())
      takes_away = takes_away || composite->operation != Operation::union_of;
  const std::size_t rays = std::min(kRays, kMostTests / tree.count);
  if (!takes_away || rays < kRays / 8) return tree.bounds;  // they would tell nothing, or take long
  const Sampling sampling = sample(tree, rays, std::move(stop));
  if (!sampling.inside) return tree.bounds;
  // Between two rays something may reach beyond what both met.
  const glm::dvec3 gap =
      (tree.bounds.high - tree.bounds.low) * (2 / std::sqrt(static_cast<double>(rays) / 3));
  return {glm::max(sampling.met.low - gap, tree.bounds.low),
          glm::min(sampling.met.high + gap, tree.bounds.high)};
}

bool leaves_nothing(const Node& node) {
  constexpr std::size_t kMostNow = 3000;  // nodes: a few hundredths of a second
  const Composite* composite = node.composite();
  if (composite == nullptr || composite->operation == Operation::union_of ||
      node.count > kMostNow || sample(node, kRaysForEmptiness).inside)
    return false;
  const auto holds = [](const Node& part) {
    return part.primitive() != nullptr || sample(part, kRaysForEmptiness).inside.has_value();
  };
  return holds(*composite->left) &&
         (composite->operation == Operation::difference || holds(*composite->right));
}

std::vector<const Node*> empty_composites(const Node& tree, std::stop_token stop) {
  const std::vector<const Node*> nodes = preorder(tree);
  std::vector<char> filled(nodes.size());  // something is known to be in it
  std::vector<char> unknown(nodes.size());
  std::size_t work = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = *nodes[i];
    if (node.composite() == nullptr) filled[i] = 1;
    if (filled[i] != 0 || is_empty(node.bounds)) continue;
    work += node.count;
    if (stop.stop_requested()) return {};
    if (work > kMostNodes) {
      unknown[i] = 1;
      continue;
    }
    const Sampling sampling = sample(node, kRaysForEmptiness, stop);
    if (!sampling.inside) continue;
    // A point of the whole is in some of its parts as well: no need to look for one there.
    filled[i] = 1;
    const std::vector<const Node*> below(
        nodes.begin() + static_cast<std::ptrdiff_t>(i),
        nodes.begin() + static_cast<std::ptrdiff_t>(i + node.count));
    const std::vector<char> in = inside(below, *sampling.inside);
    for (std::size_t k = 1; k < in.size(); ++k) filled[i + k] = filled[i + k] || in[k];
  }
  std::vector<const Node*> found;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Composite* composite = nodes[i]->composite();
    if (composite == nullptr || filled[i] != 0 || unknown[i] != 0) continue;
    const bool left = filled[i + 1] != 0, right = filled[i + 1 + composite->left->count] != 0;
    const bool its_own = composite->operation == Operation::difference     ? left
                         : composite->operation == Operation::intersection ? left && right
                                                                           : false;
    if (its_own) found.push_back(nodes[i]);
  }
  return found;
}

}  // namespace sir::modeler
