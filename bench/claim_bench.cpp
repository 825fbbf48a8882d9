// "RGB loses small coloured areas that HSV keeps" (thesis 4.4): on docs/claim/ball, and on 180
// variants of its ball. `claim_bench [BASE]`, from the project's folder; takes a minute.
#include <cstdio>
#include <exception>
#include <map>
#include <span>
#include <string>

#include "bench/timing.h"
#include "tests/claim_ball.h"

namespace {

using namespace sir;
using quant::Space;
using quant::SplitOrder;

constexpr std::pair<SplitOrder, const char*> kOrders[] = {{SplitOrder::pixels, "pixels"},
                                                          {SplitOrder::breadth, "breadth"},
                                                          {SplitOrder::longest, "longest"}};

void tell_one(const std::filesystem::path& base) {
  const test::BallImage scene(base, {}, {640, 480});
  std::printf("%zu pixels of ball in 640x480\nsplit    space  ball rms  hue lost  image rms\n",
              scene.pixels());
  for (const auto& [order, name] : kOrders)
    for (const auto& [space, word] : {std::pair(Space::rgb, "rgb"), std::pair(Space::hsv, "hsv")}) {
      const test::BallLoss loss = scene.loss(space, order);
      std::printf("%-8s %-5s  %8.1f  %7.1f%%  %9.2f\n", name, word, loss.ball, 100 * loss.hue,
                  loss.image);
    }
}

struct Tally {
  int cases = 0, claimed = 0, reversed = 0;
  std::vector<double> ratios;
};

void tell_many(const std::filesystem::path& base) {
  const glm::dvec3 colours[] = {{0.1, 0.7, 0.15}, {0.5, 0.1, 0.7},  {0.1, 0.2, 0.8},
                                {0.9, 0.4, 0.05}, {0.05, 0.6, 0.6}, {0.8, 0.1, 0.5}};
  const std::pair<double, double> places[] = {{-1.6, 0.6}, {0.2, 1.5}, {-2.6, -3}};
  std::map<const char*, Tally> tallies;
  const double radii[] = {0.06, 0.08, 0.1, 0.15, 0.25};
  const auto some = [](const auto& all) {
    const int count = bench::rounds(static_cast<int>(std::size(all)));
    return std::span(all).first(static_cast<std::size_t>(count));
  };
  for (const double radius : some(radii))
    for (const auto& [x, z] : places)
      for (const glm::dvec3& colour : some(colours))
        for (const ImageSize size : {ImageSize{320, 240}, ImageSize{640, 480}}) {
          const test::BallImage scene(base, {colour, radius, x, z}, size);
          for (const auto& [order, name] : kOrders) {
            const double ratio =
                scene.loss(Space::rgb, order).ball / scene.loss(Space::hsv, order).ball;
            Tally& tally = tallies[name];
            ++tally.cases;
            tally.claimed += ratio > 1.5;
            tally.reversed += ratio < 1 / 1.5;
            tally.ratios.push_back(ratio);
          }
        }
  std::printf("\nball rms, rgb / hsv: 5 radii, 3 places, 6 colours, 2 image sizes\n");
  for (const auto& [order, name] : kOrders) {
    const Tally& tally = tallies[name];
    std::printf("%-8s median %.2f; above 1.5 in %d of %d, below 1/1.5 in %d\n", name,
                bench::median(tally.ratios), tally.claimed, tally.cases, tally.reversed);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  const std::filesystem::path base = argc > 1 ? argv[1] : "docs/claim/ball";
  tell_one(base);
  tell_many(base);
} catch (const std::exception& error) {
  std::fprintf(stderr, "claim_bench: %s\n", error.what());
  return 1;
}
