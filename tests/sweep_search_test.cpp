// The search along the first coordinate equals that of all entries, to the index and the bit.
#include "quant/sweep_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>
#include <vector>

namespace sir::quant {
namespace {

using Nearest = SweepSearch::Nearest;

/// The definition, from the last to the first.
Nearest by_definition(std::span<const glm::vec3> entries, const glm::vec3& at, const Form& form) {
  Nearest nearest;
  for (std::size_t i = entries.size(); i-- > 0;) {
    const Nearest one{static_cast<std::uint32_t>(i), form(at - entries[i])};
    if (one.difference <= nearest.difference) nearest = one;
  }
  return nearest;
}

void expect_same(std::span<const glm::vec3> entries, const glm::vec3& at, const Form& form) {
  const Nearest one = SweepSearch(entries).nearest(at, form);
  const Nearest expected = by_definition(entries, at, form);
  ASSERT_EQ(one.index, expected.index);
  ASSERT_EQ(one.difference, expected.difference);
}

float uniform(std::mt19937& random, float low, float high) {
  return low + (high - low) * static_cast<float>(random() >> 8) / 16777216.0f;
}

/// Any form that is positive.
Form any_form(std::mt19937& random) {
  Form form{uniform(random, 0.01f, 2), uniform(random, 0.01f, 2), uniform(random, 0.01f, 2), 0};
  form.yz = uniform(random, -1.9f, 1.9f) * std::sqrt(form.yy * form.zz);
  return form;
}

TEST(SweepSearch, EqualsTheDefinitionAnywhere) {
  std::mt19937 random(1);
  for (int n = 0; n < 4000; ++n) {
    std::vector<glm::vec3> entries(1 + random() % (n % 2 ? 256 : 8));
    const float spread = uniform(random, 0.1f, 100);
    for (glm::vec3& entry : entries)
      for (int c = 0; c < 3; ++c) entry[c] = uniform(random, -spread, spread);
    for (int m = 0; m < 10; ++m) {
      glm::vec3 at{};
      for (int c = 0; c < 3; ++c) at[c] = uniform(random, -2 * spread, 2 * spread);
      expect_same(entries, at, any_form(random));
    }
  }
}

// Few values in every coordinate: many entries are equal, or equally far, or share their x.
TEST(SweepSearch, TiesTakeTheLowestIndex) {
  std::mt19937 random(2);
  for (int n = 0; n < 4000; ++n) {
    std::vector<glm::vec3> entries(1 + random() % 60);
    const unsigned levels[] = {1 + static_cast<unsigned>(random() % 4), 3, 3};
    const auto any = [&] {
      return glm::vec3(static_cast<float>(random() % levels[0]),
                       static_cast<float>(random() % levels[1]),
                       static_cast<float>(random() % levels[2]));
    };
    for (glm::vec3& entry : entries) entry = any();
    for (int m = 0; m < 10; ++m) expect_same(entries, any(), m % 2 ? Form{} : any_form(random));
  }
}

TEST(SweepSearch, EntriesOfOneXAreAllTried) {
  std::vector<glm::vec3> entries;
  for (int i = 0; i < 256; ++i) entries.push_back({5, static_cast<float>(i), 0});
  for (int i = 0; i < 256; ++i)
    for (const float x : {-1e6f, 4.0f, 5.0f, 6.0f, 1e6f})
      expect_same(entries, {x, static_cast<float>(i) + 0.5f, 1}, {});
}

TEST(SweepSearch, NeedsAnEntry) { EXPECT_THROW(SweepSearch({}), std::invalid_argument); }

}  // namespace
}  // namespace sir::quant
