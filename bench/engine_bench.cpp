// What do the hierarchy of envelopes and the flattened composition save against
// the plain algorithm of Roth, and what does a chain cost against a balanced
// tree? Usage: engine_bench [PRIMITIVES]
// Runs are paired and interleaved, one thread, 64x64 pixels; exit code 1 where
// two images differ.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "bench/timing.h"
#include "tracer/render.h"

namespace {

using sir::bench::median;
using namespace sir;

const int kPairs = sir::bench::rounds(7);

// A union of n random primitives, as a left-deep chain or a balanced tree.
Scene cloud(int n, bool chain) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  Scene scene;
  std::vector<std::size_t> level;
  for (int i = 0; i < n; ++i) {
    CsgNode node;
    node.number = i;
    node.kind = static_cast<PrimitiveKind>(i % 4);
    node.surfaces.fill(1);
    node.placement.linear = glm::dmat3(1.2 * std::cbrt(1.0 / n));
    node.placement.translation = {any(random), any(random), any(random)};
    level.push_back(scene.tree.nodes.size());
    scene.tree.nodes.push_back(node);
  }
  const auto join = [&](std::size_t left, std::size_t right) {
    CsgNode node;
    node.number = static_cast<std::int64_t>(scene.tree.nodes.size());
    node.composite = true;
    node.left = left;
    node.right = right;
    scene.tree.nodes.push_back(node);
    return scene.tree.nodes.size() - 1;
  };
  while (level.size() > 1) {
    std::vector<std::size_t> above;
    if (chain) {
      std::size_t top = level[0];
      for (std::size_t i = 1; i < level.size(); ++i) top = join(top, level[i]);
      above = {top};
    } else {
      for (std::size_t i = 0; i + 1 < level.size(); i += 2)
        above.push_back(join(level[i], level[i + 1]));
      if (level.size() % 2) above.push_back(level.back());
    }
    level = above;
  }
  scene.tree.root = level[0];
  scene.surfaces.resize(1);
  scene.surfaces[0].number = 1;
  scene.surfaces[0].first.diffuse = {0.8, 0.7, 0.6};
  scene.camera = {{2.4, 2.4}, {0, 0, 0}, {0, 0, -1}, 4, {0, 1, 0}, false, 4, false};
  scene.lighting.lights = {{{3, 5, 6}, glm::dvec3(1)}};
  return scene;
}

struct Timed {
  double ms;
  Planes planes;
};

Timed run(const Scene& scene, Engine engine) {
  RenderOptions options;
  options.size = {64, 64};
  options.threads = 1;
  options.trace.engine = engine;
  RenderResult result = render(scene, options);
  return {result.trace_seconds * 1e3, std::move(result.planes)};
}

bool compare(const char* label, const Scene& a, Engine engine_a, const Scene& b, Engine engine_b) {
  std::vector<double> times_a, times_b, ratios;
  bool equal = true;
  for (int i = 0; i < kPairs; ++i) {
    const Timed first = run(a, engine_a), second = run(b, engine_b);
    times_a.push_back(first.ms);
    times_b.push_back(second.ms);
    ratios.push_back(first.ms / second.ms);
    equal = equal && first.planes == second.planes;
  }
  std::sort(ratios.begin(), ratios.end());
  std::printf("%-34s %10.2f ms %10.2f ms   ratio %8.2f  (%.2f to %.2f)%s\n", label, median(times_a),
              median(times_b), median(ratios), ratios.front(), ratios.back(),
              equal ? "" : "  IMAGES DIFFER");
  return equal;
}

}  // namespace

int main(int argc, char** argv) {
  const int most = argc > 1 ? std::atoi(argv[1]) : 3000;
  if (most < 1) {
    std::fprintf(stderr, "usage: engine_bench [PRIMITIVES]\n");
    return 2;
  }
  bool equal = true;
  for (int n = std::min(30, most); n <= most; n *= 10) {
    std::printf("%d primitives, union\n", n);
    const Scene chain = cloud(n, true), tree = cloud(n, false);
    if (n <= 300)
      equal &= compare("  roth / gates (tree)", tree, Engine::roth, tree, Engine::gates);
    equal &= compare("  chain / tree (gates)", chain, Engine::gates, tree, Engine::gates);
  }
  return equal ? 0 : 1;
}
