// A palette's steps: the cost never rises, and is what the entries' codes cost.
#include "quant/palette.h"

#include <gtest/gtest.h>

#include "bench/made_up.h"
#include "tests/best_pictures.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"

namespace sir::test {
namespace {

using namespace quant;

double cost_of_codes(const Palette& palette, ColourMeasure& measure, const DacBits& dac) {
  double cost = 0;
  for (std::size_t i = 0; i < palette.size(); ++i)
    if (palette.sum(i).points > 0)
      cost += palette.sum(i).cost(glm::dvec3(measure.point_of(seen(palette.codes()[i], dac))));
  return cost;
}

void expect_steps(const Planes& picture, Goal goal, std::size_t entries, const DacBits& dac) {
  ColourMeasure measure(goal);
  const ColourPoints points = colours_of(picture).points(measure, 1 << 24);
  Palette palette(points.all, measure, dac, split_into(points.all, entries));
  palette.assign();
  double before = palette.cost();
  const auto not_more = [&](const char* what) {
    EXPECT_LE(palette.cost(), before * (1 + 1e-6) + 1e-6) << what;
    before = palette.cost();
  };
  for (int i = 0; i < 6; ++i) {
    palette.step();
    not_more("step");
  }
  for (const std::size_t most : {16, 16, 8, 4}) {
    palette.swap(most, 1);
    not_more("swap");
  }
  for (int i = 0; i < 6; ++i) palette.step();
  palette.hold();
  const auto on_codes = [&](const char* what) {
    const double cost = palette.cost();
    EXPECT_NEAR(cost_of_codes(palette, measure, dac), cost, 1e-9 * cost + 1e-6) << what;
  };
  on_codes("hold");
  before = palette.cost();
  for (int i = 0; i < 6; ++i) {
    palette.step();
    not_more("step, held");
    on_codes("step, held");
    palette.nudge(8);
    not_more("nudge");
    on_codes("nudge");
    palette.swap(8, 0.7);
    not_more("swap, held");
    on_codes("swap, held");
  }
  std::size_t sum = 0;
  for (std::size_t i = 0; i < palette.size(); ++i) sum += palette.sum(i).points;
  EXPECT_EQ(sum, points.all.size());
}

TEST(Palette, StepsNeverRaiseTheCost) {
  RenderOptions small;
  small.size = {160, 120};
  for (const Planes& picture :
       {render(read_scene(SIR_IMAGES "/whitted"), small).planes,
        render(read_scene(SIR_IMAGES "/piramide"), small).planes, slopes({60, 45}),
        thinned(bench::grainy_balls(), 8), clusters({40, 40}, 1, 5, 2)})
    for (const Goal goal : kGoals)
      for (const std::size_t entries : {1, 30, 256})
        for (const DacBits& dac : {DacBits{}, DacBits{{4, 4, 4}}}) {
          if (entries == 30 && dac != DacBits{}) continue;
          SCOPED_TRACE(std::string(name_of(goal)) + ", " + std::to_string(entries) + " entries");
          expect_steps(picture, goal, entries, dac);
        }
}

}  // namespace
}  // namespace sir::test
