// The thesis's table of costs (2.5), measured: what the plain algorithm of Roth does, and what
// each cure leaves of it.
// Usage: cost_bench [PRIMITIVES [SIDE]]   (300 primitives, 500x500, as in the thesis)
// Primary rays only, as in Roth's example; one thread; CPU time, the median of interleaved
// rounds; then the same with shadows. Exit code 1 where two images differ, or the plain
// algorithm's costs are not those of the formula.
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <vector>

#include "bench/child.h"
#include "bench/scenes.h"
#include "bench/timing.h"
#include "tracer/render.h"

namespace {

using namespace sir;
using namespace sir::bench;

const int kRounds = sir::bench::rounds(3);

// The cures of thesis 2.5.2 on the plain algorithm; then what SIR has instead of them, one on top
// of the other.
struct Cure {
  const char* name;
  Engine engine;
  bool products, packets;
};
constexpr Cure kCures[] = {
    {"plain", Engine::roth, false, false},
    {"envelopes on the tree", Engine::envelopes, false, false},
    {"hierarchy, gates", Engine::gates, false, false},
    {"+ first hit by products", Engine::gates, true, false},
    {"+ packets", Engine::gates, true, true},
};

struct Row {
  RenderResult result;
  std::vector<double> seconds;
};

void print_counts(const char* name, const CostCounts& costs) {
  std::printf("  %-24s %13" PRIu64 " %13" PRIu64 " %13" PRIu64 " %13" PRIu64 " %13" PRIu64, name,
              costs.calls, costs.combinations, costs.transformations(), costs.intersection_tests(),
              costs.envelopes);
}

// The formula for one tree and a number of rays.
bool is_roths_formula(const CostCounts& costs, const Scene& scene, std::uint64_t rays) {
  std::uint64_t primitives = 0, faces = 0;
  for (const CsgNode& node : scene.tree.nodes) {
    if (node.composite) continue;
    ++primitives;
    faces += static_cast<std::uint64_t>(face_count(node.kind));
  }
  return costs.calls == rays * (2 * primitives - 1) &&
         costs.combinations == rays * (primitives - 1) &&
         costs.transformations() == rays * primitives && costs.intersection_tests() == rays * faces;
}

bool measure(const MadeScene& made, int side, bool shadows) {
  const Scene scene = made_scene(made);
  RenderOptions options;
  options.size = {side, side};
  options.threads = 1;
  options.trace.depth_limit = 1;
  options.trace.allowed_effects.shadow = shadows;
  const Model<double> model(scene, options.trace.possible_effects());
  Model<double> without_products(scene, options.trace.possible_effects());
  without_products.solid.products.complete = false;
  without_products.laid_out = nullptr;
  std::vector<Row> rows(std::size(kCures));
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < rows.size(); ++i) {
      options.trace.engine = kCures[i].engine;
      options.trace.packets = kCures[i].packets;
      const double start = own_cpu_seconds();
      rows[i].result = render_model(kCures[i].products ? model : without_products, options);
      rows[i].seconds.push_back(own_cpu_seconds() - start);
    }
  const RayCounts& rays = rows[0].result.counts;
  std::printf("\n%s, %dx%d: %" PRIu64 " primary rays, %" PRIu64 " shadow rays\n",
              made.name().c_str(), side, side, rays.primary, rays.shadow);
  std::printf("  %-24s %13s %13s %13s %13s %13s %9s  %s\n", "", "calls", "combinations",
              "transforms", "tests", "envelopes", "CPU s", "saves");
  bool right = shadows || is_roths_formula(rays.costs, scene, rays.primary);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    print_counts(kCures[i].name, rows[i].result.counts.costs);
    std::vector<double> shares;
    for (int round = 0; round < kRounds; ++round) {
      const auto at = static_cast<std::size_t>(round);
      shares.push_back(rows[i].seconds[at] / rows[0].seconds[at]);
    }
    std::printf(" %9.3f", median(rows[i].seconds));
    if (i > 0) std::printf("  %.1f %%, %.1fx", 100 * (1 - median(shares)), 1 / median(shares));
    const bool same = rows[i].result.planes == rows[0].result.planes;
    std::printf("%s\n", same ? "" : "  IMAGES DIFFER");
    right = right && same;
  }
  const RayCounts& last = rows.back().result.counts;
  std::printf("  %" PRIu64 " packets; %" PRIu64 " rays were left in doubt and traced one by one\n",
              last.packets, last.doubtful);
  return right && last.packets > 0;
}

}  // namespace

int main(int count, char** arguments) {
  const int primitives = count > 1 ? std::atoi(arguments[1]) : 300;
  const int side = count > 2 ? std::atoi(arguments[2]) : 500;
  if (count > 3 || primitives < 1 || side < 1) {
    std::fprintf(stderr, "usage: cost_bench [PRIMITIVES [SIDE]]\n");
    return 2;
  }
  std::printf(
      "Thesis 2.5, 300 primitives of 4 surfaces, 500x500; 599 calls and 299 combinations a "
      "ray are rounded there:\n");
  CostCounts roth;
  roth.calls = 150'000'000;
  roth.combinations = 75'000'000;
  // Half of them of 6 surfaces, half of 2.
  roth.primitives = {37'500'000, 0, 37'500'000, 0};
  print_counts("Roth's estimate", roth);
  std::printf("\nEnvelopes were found to save up to 50 %% of the time.\n");
  bool right = true;
  for (const bool shadows : {false, true})
    for (const bool chain : {true, false})
      right = measure({.primitives = primitives, .chain = chain}, side, shadows) && right;
  if (!right) std::printf("NOT RIGHT\n");
  return right ? 0 : 1;
}
