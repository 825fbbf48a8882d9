// The colours of pictures counted, weighted and taken together.
#include "quant/colour_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <tuple>

#include "bench/made_up.h"
#include "quant/image_pair.h"
#include "tests/random_planes.h"

namespace sir::quant {
namespace {

using test::random_planes;
using Counts = std::map<std::uint32_t, double>;

/// Noise of few colours, so that most come often.
Planes few_colours(ImageSize size, unsigned seed, unsigned levels) {
  Planes image = random_planes(size, seed);
  for (auto& plane : image.channel)
    for (auto& byte : plane) byte = static_cast<std::uint8_t>(byte % levels * (255 / levels));
  return image;
}

std::vector<std::uint8_t> random_importance(const Planes& image, unsigned seed) {
  return random_planes(image.size, seed).channel[0];
}

void count(Counts& counts, const Planes& image, std::span<const std::uint8_t> importance = {}) {
  for (std::size_t i = 0; i < image.size.pixels(); ++i)
    if (const int weight = importance.empty() ? 255 : int{importance[i]})
      counts[packed(image.at(i))] += weight / 255.0;
}

void expect_counts(const WeightedColours& colours, const Counts& counts) {
  ASSERT_EQ(colours.all().size(), counts.size());
  for (const WeightedColour& one : colours.all()) {
    const auto found = counts.find(packed(one.colour));
    ASSERT_NE(found, counts.end());
    ASSERT_NEAR(one.weight, found->second, 1e-9 * found->second);
  }
}

/// The three bytes' bits in turn, from the highest: g before b, r before g.
std::uint32_t morton(Rgb8 colour) {
  std::uint32_t code = 0;
  for (int bit = 7; bit >= 0; --bit)
    for (const std::uint8_t byte : {colour.r, colour.g, colour.b})
      code = code << 1 | (byte >> bit & 1u);
  return code;
}

void expect_order(const WeightedColours& colours) {
  for (std::size_t i = 1; i < colours.all().size(); ++i)
    ASSERT_LT(morton(colours.all()[i - 1].colour), morton(colours.all()[i].colour));
}

TEST(WeightedColours, CountsEveryPixelOnce) {
  for (const Planes& image :
       {random_planes({80, 60}, 1), few_colours({80, 60}, 2, 3), few_colours({1, 77}, 3, 6),
        random_planes({1, 1}, 4), bench::balls()}) {
    WeightedColours colours;
    colours.add(image);
    Counts counts;
    count(counts, image);
    expect_counts(colours, counts);
    expect_order(colours);
  }
}

TEST(WeightedColours, OfSeveralImagesAreThoseOfAllTogether) {
  WeightedColours colours;
  Counts counts;
  for (unsigned seed = 1; seed < 8; ++seed) {
    const Planes image =
        seed % 3 == 0 ? random_planes({40, 30}, seed) : few_colours({40, 30}, seed, 2 + seed);
    if (seed % 2 == 0) {
      const auto importance = random_importance(image, 100 + seed);
      colours.add(image, importance);
      count(counts, image, importance);
    } else {
      colours.add(image);
      count(counts, image);
    }
    expect_counts(colours, counts);
    expect_order(colours);
  }
}

TEST(WeightedColours, PixelsOfNoImportanceDoNotCount) {
  const Planes image = few_colours({50, 40}, 5, 5);
  auto importance = random_importance(image, 6);
  for (std::size_t i = 0; i < importance.size(); ++i)
    if (image.at(i).r == 0 || i % 3 == 0) importance[i] = 0;
  WeightedColours colours;
  colours.add(image, importance);
  Counts counts;
  count(counts, image, importance);
  expect_counts(colours, counts);
  for (const WeightedColour& one : colours.all()) EXPECT_NE(one.colour.r, 0);

  WeightedColours none;
  none.add(image, std::vector<std::uint8_t>(image.size.pixels(), 0));
  none.add(Planes{});
  EXPECT_TRUE(none.all().empty());
  EXPECT_THROW(none.add(image, std::vector<std::uint8_t>(7, 1)), std::invalid_argument);
}

double total(const WeightedColours& colours) {
  double sum = 0;
  for (const WeightedColour& one : colours.all()) sum += one.weight;
  return sum;
}

/// All that is promised of points under a limit. An entry's cost is that of the colours: what
/// it costs for points, and the scatter about them.
void expect_points(const WeightedColours& colours, Goal goal, std::size_t limit) {
  ColourMeasure measure(goal);
  const ColourPoints points = colours.points(measure, limit);
  ASSERT_LE(points.all.size(), limit);
  ASSERT_GE(points.all.size(), 1u);
  double weight = 0;
  for (const ColourPoint& point : points.all) weight += double{point.weight};
  EXPECT_NEAR(weight, total(colours), 1e-5 * weight);
  EXPECT_GE(points.scatter, 0);

  // The cubes once more: the least side for which there are few enough.
  int shift = 0;
  std::map<std::uint32_t, std::vector<WeightedColour>> cubes;
  for (;; ++shift) {
    cubes.clear();
    for (const WeightedColour& one : colours.all())
      cubes[morton(one.colour) >> 3 * shift].push_back(one);
    if (cubes.size() <= limit) break;
  }
  ASSERT_EQ(points.all.size(), cubes.size());
  const glm::dvec3 entry(measure.point_of({120, 130, 90}));
  double together = points.scatter, one_by_one = 0;
  auto point = points.all.begin();
  for (const auto& [code, cube] : cubes) {
    const auto cost = [&](const glm::dvec3& at, double w) {
      const glm::dvec3 d = at - entry;
      return w * (double{point->form.xx} * d.x * d.x + double{point->form.yy} * d.y * d.y +
                  double{point->form.zz} * d.z * d.z + double{point->form.yz} * d.y * d.z);
    };
    for (const WeightedColour& one : cube)
      one_by_one += cost(glm::dvec3(measure.point_of(one.colour)), one.weight);
    together += cost(glm::dvec3(point->at), double{point->weight});
    ++point;
  }
  EXPECT_NEAR(together, one_by_one, 1e-5 * one_by_one) << limit;
}

TEST(ColourPoints, KeepWeightMeanAndScatter) {
  WeightedColours noise, ball, weighted;
  noise.add(random_planes({100, 80}, 7));
  ball.add(bench::balls());
  const Planes few = few_colours({60, 60}, 8, 30);
  weighted.add(few, random_importance(few, 9));
  for (const WeightedColours* colours : {&noise, &ball, &weighted})
    for (const Goal goal : {Goal::perceptual, Goal::psnr})
      for (const std::size_t limit : {std::size_t{1}, std::size_t{8}, std::size_t{100},
                                      std::size_t{1000}, std::size_t{5000}, std::size_t{1} << 24})
        expect_points(*colours, goal, limit);
}

TEST(ColourPoints, AreTheColoursWhereThereIsRoom) {
  const Planes image = random_planes({60, 50}, 10);
  WeightedColours colours;
  colours.add(image);
  ColourMeasure measure(Goal::perceptual);
  const auto points = colours.points(measure, colours.all().size());
  ASSERT_EQ(points.all.size(), colours.all().size());
  EXPECT_EQ(points.scatter, 0);
  for (std::size_t i = 0; i < points.all.size(); ++i) {
    const Rgb8 colour = colours.all()[i].colour;
    EXPECT_EQ(points.all[i].at, measure.point_of(colour));
    EXPECT_EQ(points.all[i].bytes, glm::vec3(colour.r, colour.g, colour.b));
    EXPECT_EQ(points.all[i].form.yz, measure.form_of(colour).yz);
  }
  EXPECT_LT(colours.points(measure, colours.all().size() - 1).all.size(), points.all.size());
}

TEST(ColourPoints, OfNoColoursAreNone) {
  ColourMeasure measure(Goal::psnr);
  EXPECT_TRUE(WeightedColours().points(measure, 10).all.empty());
}

}  // namespace
}  // namespace sir::quant
