// Costs out of sums against costs point by point.
#include "quant/form_sum.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace sir::quant {
namespace {

float uniform(std::mt19937& random, float low, float high) {
  return low + (high - low) * static_cast<float>(random() >> 8) / 16777216.0f;
}

std::vector<ColourPoint> random_points(std::mt19937& random, std::size_t count) {
  std::vector<ColourPoint> points(count);
  for (ColourPoint& point : points) {
    point.at = {uniform(random, 0, 100), uniform(random, -90, 90), uniform(random, -90, 90)};
    point.form = {uniform(random, 0.05f, 1), uniform(random, 0.05f, 1), uniform(random, 0.05f, 1),
                  0};
    point.form.yz = uniform(random, -1.9f, 1.9f) * std::sqrt(point.form.yy * point.form.zz);
    point.bytes = {uniform(random, 0, 255), uniform(random, 0, 255), uniform(random, 0, 255)};
    point.weight = uniform(random, 0.004f, 1000);
  }
  return points;
}

FormSum summed(std::span<const ColourPoint> points) {
  FormSum sum;
  for (const ColourPoint& point : points) sum.add(point);
  return sum;
}

double direct_cost(std::span<const ColourPoint> points, const glm::dvec3& entry) {
  double cost = 0;
  for (const ColourPoint& point : points) {
    const glm::dvec3 d = glm::dvec3(point.at) - entry;
    const Form& f = point.form;
    cost += double{point.weight} * (double{f.xx} * d.x * d.x + double{f.yy} * d.y * d.y +
                                    double{f.zz} * d.z * d.z + double{f.yz} * d.y * d.z);
  }
  return cost;
}

glm::dvec3 any_place(std::mt19937& random, const glm::dvec3& centre, float reach) {
  glm::dvec3 place = centre;
  for (int c = 0; c < 3; ++c) place[c] += double{uniform(random, -reach, reach)};
  return place;
}

TEST(FormSum, CostsWhatThePointsCost) {
  std::mt19937 random(1);
  for (int n = 0; n < 500; ++n) {
    const auto points = random_points(random, 1 + random() % 40);
    const FormSum sum = summed(points);
    for (int m = 0; m < 10; ++m) {
      const glm::dvec3 entry = any_place(random, {50, 0, 0}, 60);
      const double direct = direct_cost(points, entry);
      ASSERT_NEAR(sum.cost(entry), direct, 1e-9 * (direct + sum.rest));
    }
    EXPECT_EQ(sum.points, points.size());
  }
}

TEST(FormSum, NothingIsCheaperThanTheBest) {
  std::mt19937 random(2);
  for (int n = 0; n < 500; ++n) {
    const auto points = random_points(random, 1 + random() % 40);
    const FormSum sum = summed(points);
    const double least = direct_cost(points, sum.best());
    EXPECT_NEAR(sum.least(), least, 1e-9 * (least + sum.rest));
    for (const float reach : {1e-3f, 0.1f, 10.0f})
      for (int m = 0; m < 20; ++m)
        ASSERT_LE(least, direct_cost(points, any_place(random, sum.best(), reach)) * (1 + 1e-9));
  }
}

TEST(FormSum, OfOnePointIsBestAtIt) {
  std::mt19937 random(3);
  for (const ColourPoint& point : random_points(random, 1000)) {
    const FormSum sum = summed({&point, 1});
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(sum.best()[c], double{point.at[c]}, 1e-6);
    ASSERT_LE(sum.least(), 1e-9 * sum.rest);
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(sum.mean_bytes()[c], double{point.bytes[c]}, 1e-4);
    ASSERT_FLOAT_EQ(sum.mean_form().yz, point.form.yz);
    ASSERT_FLOAT_EQ(sum.mean_form().xx, point.form.xx);
  }
}

TEST(FormSum, WhatIsRemovedWasNeverThere) {
  std::mt19937 random(4);
  for (int n = 0; n < 200; ++n) {
    const auto points = random_points(random, 60);
    const std::span all(points);
    const std::size_t kept = 1 + random() % 59;
    FormSum removed = summed(all);
    for (const ColourPoint& point : all.subspan(kept)) removed.remove(point);
    FormSum joined = summed(all.first(kept / 2));
    joined += summed(all.subspan(kept / 2, kept - kept / 2));
    for (const FormSum& sum : {removed, joined}) {
      EXPECT_EQ(sum.points, kept);
      const glm::dvec3 entry = any_place(random, {50, 0, 0}, 60);
      const double direct = direct_cost(all.first(kept), entry);
      ASSERT_NEAR(sum.cost(entry), direct, 1e-9 * summed(all).rest);
      ASSERT_NEAR(sum.mean_bytes().x, summed(all.first(kept)).mean_bytes().x, 1e-4);
    }
  }
}

TEST(FormSum, IsNeverBelowNothing) {
  std::mt19937 random(5);
  for (const ColourPoint& point : random_points(random, 1000)) {
    FormSum sum;
    for (int i = 0; i < 1000; ++i) sum.add(point);
    ASSERT_GE(sum.cost(glm::dvec3(point.at)), 0);
    ASSERT_GE(sum.least(), 0);
  }
  EXPECT_EQ(FormSum{}.least(), 0);
  EXPECT_EQ(FormSum{}.cost({1, 2, 3}), 0);
}

}  // namespace
}  // namespace sir::quant
