// The method `best`: never worse than the thesis's methods at what it is asked for.
#include "quant/best.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "bench/made_up.h"
#include "tests/best_pictures.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"

namespace sir::test {
namespace {

using namespace quant;

struct Picture {
  std::string name;
  Planes planes;
};

const std::vector<Picture>& pictures() {
  static const std::vector<Picture> all = [] {
    RenderOptions small;
    small.size = {160, 120};
    return std::vector<Picture>{
        {"whitted", render(read_scene(SIR_IMAGES "/whitted"), small).planes},
        {"piramide", render(read_scene(SIR_IMAGES "/piramide"), small).planes},
        {"grainy balls", thinned(bench::grainy_balls(), 4)},
        {"noise", random_planes({90, 60}, 1)},
        {"slopes", slopes({120, 90})},
        {"clusters", clusters({100, 100}, 2, 30, 24)}};
  }();
  return all;
}

/// The same, every second row and column.
const std::vector<Picture>& small_pictures() {
  static const std::vector<Picture> all = [] {
    std::vector<Picture> small;
    for (const auto& [name, planes] : pictures()) small.push_back({name, thinned(planes, 2)});
    return small;
  }();
  return all;
}

TEST(Best, TheSameInputGivesTheSameLut) {
  for (const auto& [name, planes] : small_pictures())
    for (const Goal goal : kGoals) {
      BestOptions options;
      options.goal = goal;
      const BestChoice choice = best_for(planes, options);
      const BestChoice again = best_for(planes, options);
      EXPECT_EQ(again.lut, choice.lut) << name;
      EXPECT_EQ(again.error, choice.error) << name;
      // A colour counts, not its place.
      Planes turned = planes;
      for (auto& plane : turned.channel) std::reverse(plane.begin(), plane.end());
      EXPECT_EQ(best_for(turned, options).lut, choice.lut) << name;
    }
}

TEST(Best, IsNeverWorseThanTheThesissMethods) {
  for (const auto& [name, planes] : pictures())
    for (const Goal goal : kGoals) {
      BestOptions options;
      options.goal = goal;
      const double error = error_of(goal, planes, best_for(planes, options).lut);
      for (const Method method : {Method::frequency, Method::median})
        for (const Space space : {Space::rgb, Space::hsv})
          for (const SplitOrder split : {SplitOrder::pixels, SplitOrder::longest}) {
            ChooseOptions thesis;
            thesis.method = method;
            thesis.space = space;
            thesis.split = split;
            EXPECT_LT(error, error_of(goal, planes, choose_lut(planes, thesis)))
                << name << ", " << name_of(goal);
          }
    }
}

// Each goal is better at its own measure than the other is.
TEST(Best, GoalsAreWhatTheySay) {
  for (const auto& [name, planes] : pictures()) {
    BestOptions options;
    options.goal = Goal::psnr;
    const Lut by_bytes = best_for(planes, options).lut;
    const Lut by_eye = best_for(planes).lut;
    EXPECT_LT(error_of(Goal::psnr, planes, by_bytes), error_of(Goal::psnr, planes, by_eye)) << name;
    EXPECT_LT(error_of(Goal::perceptual, planes, by_eye),
              error_of(Goal::perceptual, planes, by_bytes))
        << name;
  }
}

// Every effort ends where no move that it knows gains, which need not be the same place: more
// effort may end a little worse, by a thousandth where it is the greatest.
TEST(Best, MoreEffortIsNotWorse) {
  for (const auto& [name, small] : small_pictures()) {
    for (const Goal goal : kGoals) {
      std::vector<double> errors;
      for (int effort = kMinEffort; effort <= kMaxEffort; ++effort) {
        BestOptions options;
        options.goal = goal;
        options.effort = effort;
        options.entries = 64;
        errors.push_back(error_of(goal, small, best_for(small, options).lut));
      }
      for (std::size_t i = 1; i < errors.size(); ++i)
        EXPECT_LE(errors[i], 1.01 * errors[i - 1])
            << name << ", " << name_of(goal) << ", " << i + 1;
      EXPECT_LE(errors[4], 1.001 * errors[2]) << name << ", " << name_of(goal);
    }
  }
}

TEST(Best, MoreEntriesAreBetter) {
  for (const auto& [name, planes] : small_pictures())
    for (const Goal goal : kGoals) {
      double before = std::numeric_limits<double>::infinity();
      for (const std::size_t entries : {1, 2, 3, 16, 64, 256}) {
        BestOptions options;
        options.goal = goal;
        options.entries = entries;
        const BestChoice choice = best_for(planes, options);
        EXPECT_EQ(choice.entries, entries) << name;
        EXPECT_EQ(choice.lut.chosen, entries) << name;
        const double error = error_of(goal, planes, choice.lut);
        EXPECT_LT(error, before) << name << ", " << entries;
        before = error;
      }
    }
}

TEST(Best, EntriesGoFromDarkToLight) {
  for (const auto& [name, planes] : small_pictures()) {
    const BestChoice choice = best_for(planes);
    ColourMeasure measure(Goal::perceptual);
    for (std::size_t i = 1; i < choice.entries; ++i)
      EXPECT_LE(measure.point_of(choice.lut.seen(i - 1)).x, measure.point_of(choice.lut.seen(i)).x)
          << name;
  }
}

TEST(Best, IsBetterOnAFinerDac) {
  for (const auto& [name, planes] : small_pictures())
    for (const Goal goal : kGoals) {
      double before = std::numeric_limits<double>::infinity();
      for (const int bits : {1, 3, 6}) {
        BestOptions options;
        options.goal = goal;
        options.dac = {{bits, bits, bits}};
        const BestChoice choice = best_for(planes, options);
        EXPECT_EQ(choice.lut.dac, options.dac);
        const double error = error_of(goal, planes, choice.lut);
        EXPECT_LT(error, before) << name << ", " << bits << " bits";
        before = error;
      }
    }
}

TEST(Best, OneLutForSeveralImagesIsThatOfAllInOne) {
  const Planes& above = pictures()[0].planes;
  const Planes& below = pictures()[1].planes;
  Planes both(ImageSize{above.size.width, above.size.height + below.size.height});
  for (std::size_t c = 0; c < 3; ++c) {
    std::copy(above.channel[c].begin(), above.channel[c].end(), both.channel[c].begin());
    std::copy(below.channel[c].begin(), below.channel[c].end(),
              both.channel[c].begin() + static_cast<std::ptrdiff_t>(above.size.pixels()));
  }
  for (const Goal goal : kGoals) {
    BestOptions options;
    options.goal = goal;
    WeightedColours colours;
    colours.add(above);
    colours.add(below);
    EXPECT_EQ(choose_best(colours, options).lut, best_for(both, options).lut);
  }
}

}  // namespace
}  // namespace sir::test
