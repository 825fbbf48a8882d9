// What quant/best.h promises of every LUT, on pictures and options at random.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "quant/best.h"
#include "quant/hue_guard.h"
#include "tests/best_pictures.h"

namespace sir::test {
namespace {

using namespace quant;

Planes any_picture(std::mt19937& random) {
  const auto seed = static_cast<unsigned>(random());
  const auto side = [&] { return 1 + static_cast<int>(random() % 40); };
  const ImageSize size{side(), side()};
  const auto any = [&] { return static_cast<std::uint8_t>(random()); };
  switch (random() % 7) {
    case 0: return random_planes(size, seed);
    case 1: return filled(size, {any(), any(), any()});
    case 2: return filled({1, 1}, random() % 2 ? Rgb8{0, 0, 0} : Rgb8{255, 255, 255});
    case 3: return slopes(size);
    case 4: return clusters(size, seed, 1 + static_cast<int>(random() % 5), 2);
    case 5: return clusters(size, seed, 1 + static_cast<int>(random() % 300), 3);
    default: return clusters(size, seed, 1 + static_cast<int>(random() % 12), 40);
  }
}

DacBits any_dac(std::mt19937& random) {
  constexpr DacBits kSome[] = {{{1, 1, 1}}, {{4, 4, 4}}, {{5, 6, 5}}, {{8, 8, 8}}, {{1, 3, 7}}};
  return random() % 2 ? DacBits{} : kSome[random() % std::size(kSome)];
}

DacCode any_code(std::mt19937& random, const DacBits& dac) {
  DacCode code{};
  for (std::size_t c = 0; c < 3; ++c)
    code[c] = static_cast<std::uint8_t>(random() % static_cast<unsigned>(dac.max_code(c) + 1));
  return code;
}

BestOptions any_options(std::mt19937& random) {
  BestOptions options;
  options.goal = kGoals[random() % 2];
  options.effort = 1 + static_cast<int>(random() % 5);
  options.dac = any_dac(random);
  constexpr std::size_t kEntries[] = {1, 2, 3, 5, 16, 40, 255, 256};
  options.entries = kEntries[random() % std::size(kEntries)];
  if (random() % 3 == 0)
    for (auto n = random() % 20; n > 0 && kLutEntries - options.reserved.count() > options.entries;
         --n)
      options.reserved.set(random() % kLutEntries);
  if (random() % 3 == 0) {
    IndexSet taken = options.reserved;
    for (auto n = random() % (std::min<std::size_t>(options.entries, 12) + 1); n > 0; --n) {
      Pin pin{{}, any_code(random, options.dac)};
      const std::size_t index = random() % kLutEntries;
      if (random() % 2 && !taken[index]) {
        pin.index = index;
        taken.set(index);
      }
      options.pins.push_back(pin);
    }
  }
  // The best codes of 8,8,8 for the hues are sought among 2^24, which takes too long here.
  options.protect_hues = random() % 4 == 0 && options.dac != DacBits{{8, 8, 8}};
  if (random() % 4 == 0) {
    std::vector<DacCode> codes(1 + random() % 256);
    for (DacCode& code : codes) code = any_code(random, options.dac);
    options.from = make_lut(codes, options.dac);
  }
  return options;
}

std::string text_of(const BestOptions& options, const Planes& picture) {
  std::string text = std::string(name_of(options.goal)) + ", effort " +
                     std::to_string(options.effort) + ", " + std::to_string(options.entries) +
                     " entries, bits";
  for (const int bits : options.dac.bits) text += " " + std::to_string(bits);
  for (const Pin& pin : options.pins) text += ", pin " + pin_text(pin);
  return text + ", reserved " + std::to_string(options.reserved.count()) +
         (options.protect_hues ? ", hues protected" : "") + (options.from ? ", from a LUT" : "") +
         ", picture " + std::to_string(picture.size.width) + "x" +
         std::to_string(picture.size.height);
}

void expect_places(const BestOptions& options, const Lut& lut) {
  IndexSet taken = options.reserved;
  for (const Pin& pin : options.pins)
    if (pin.index) taken.set(*pin.index);
  std::size_t next = 0;
  for (const Pin& pin : options.pins) {
    while (!pin.index && taken[next]) ++next;
    const std::size_t index = pin.index ? *pin.index : next;
    EXPECT_EQ(lut.entry[index], pin.code);
    taken.set(index);
  }
  for (std::size_t i = 0; i < kLutEntries; ++i)
    if (options.reserved[i]) {
      EXPECT_EQ(lut.entry[i], options.from ? options.from->entry[i] : DacCode{});
    }
}

// Every plane that occurs has an entry seen in it, or is said to have none; never both.
void expect_hues(const Planes& picture, const BestOptions& options, const BestChoice& choice) {
  std::set<int> there, seen_in, lost(choice.lost_hues.begin(), choice.lost_hues.end());
  for (std::size_t i = 0; i < picture.size.pixels(); ++i) there.insert(hue_plane(picture.at(i)));
  for (std::size_t i = 0; i < kLutEntries; ++i)
    if (!options.reserved[i]) seen_in.insert(hue_plane(choice.lut.seen(i)));
  EXPECT_EQ(lost.size(), choice.lost_hues.size());
  for (const int plane : there) EXPECT_NE(seen_in.contains(plane), lost.contains(plane)) << plane;
  for (const int plane : lost) EXPECT_TRUE(there.contains(plane)) << plane;
}

void expect_promises(const Planes& picture, const BestOptions& options) {
  const BestChoice choice = best_for(picture, options);
  const Lut& lut = choice.lut;
  EXPECT_EQ(lut.dac, options.dac);
  for (const DacCode& code : lut.entry)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_LE(int{code[c]}, lut.dac.max_code(c));
  EXPECT_GE(choice.entries, 1u);
  EXPECT_LE(choice.entries, options.entries);
  EXPECT_GE(choice.entries, options.pins.size());
  std::set<DacCode> codes;
  for (std::size_t i = 0; i < kLutEntries; ++i)
    if (!options.reserved[i]) codes.insert(lut.entry[i]);
  EXPECT_LE(codes.size(), choice.entries);
  expect_places(options, lut);

  const double error = error_of(options.goal, picture, lut, options.reserved);
  EXPECT_TRUE(std::isfinite(choice.error));
  EXPECT_LE(error, choice.error * (1 + 1e-5) + 1e-6);
  EXPECT_NEAR(error, choice.error, 1e-4 * error + 1e-3);  // few colours: none taken together

  // Nothing is gained by the indices that are not used: a search over all never takes them.
  for (const Goal goal : kGoals) {
    std::set<std::uint8_t> taken;
    for (const auto index : mapped_for(goal, picture, lut, options.reserved)) taken.insert(index);
    EXPECT_LE(taken.size(), choice.entries);
  }
  if (options.protect_hues) expect_hues(picture, options, choice);
  else EXPECT_TRUE(choice.lost_hues.empty());
  EXPECT_EQ(best_for(picture, options).lut, lut);
}

TEST(BestPromises, AreKeptForAnyOptions) {
  std::mt19937 random(1);
  for (int n = 0; n < 120 && !testing::Test::HasFailure(); ++n) {
    const Planes picture = any_picture(random);
    const BestOptions options = any_options(random);
    SCOPED_TRACE(std::to_string(n) + ": " + text_of(options, picture));
    expect_promises(picture, options);
  }
}

}  // namespace
}  // namespace sir::test
