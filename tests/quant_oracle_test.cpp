// The choice of a LUT (thesis 3.4, quant/choose.h) written a second time, naively: a
// box is a list of pixels' cells, counts are maps, bins and codes are searched
// for by inequalities. The production code must agree on every entry.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <list>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "quant/choose.h"

namespace sir::quant {
namespace {

using Integer = long long;
using Point = std::array<Integer, 3>;  // RGB cell; or hue plane, saturation, value
using Pixels = std::vector<Point>;     // each pixel's cell

struct Setting {
  Space space;
  Method method;
  SplitOrder split;
  Integer hues = 36, saturations = 30, values = 30;
  Integer grey_s_percent = 20, grey_v_percent = 20;
  std::size_t sample = 1;
};

/// The integer i with i - 1/2 <= n/d < i + 1/2.
Integer nearest_integer(Integer n, Integer d) {
  Integer i = 0;
  while ((2 * i + 1) * d <= 2 * n) ++i;
  return i;
}

Point hsv_point(Rgb8 colour, const Setting& is) {
  const Integer r = colour.r, g = colour.g, b = colour.b;
  const Integer max = std::max({r, g, b}), c = max - std::min({r, g, b});
  const Integer v = nearest_integer((is.values - 1) * max, 255);
  if (100 * c <= is.grey_s_percent * max || 100 * max <= is.grey_v_percent * 255)
    return {is.hues, 0, v};
  Integer degrees;  // times c, from 0 to 360
  if (r == max) degrees = g >= b ? 60 * (g - b) : 360 * c - 60 * (b - g);
  else if (g == max) degrees = 120 * c + 60 * (b - r);
  else degrees = 240 * c + 60 * (r - g);
  // Bin h is centred on 360 h / hues; a hue beyond the last bin is bin 0's.
  Integer h = 0;
  while (h < is.hues && 2 * degrees * is.hues >= 360 * c * (2 * h + 1)) ++h;
  if (h == is.hues) h = 0;
  return {h, nearest_integer((is.saturations - 1) * c, max), v};
}

/// Mean of pixels, as a code; hsv by the formula c = v - v s max(0, min(k, 4-k, 1)).
DacCode mean_code(const Pixels& box, const Setting& is) {
  const auto n = static_cast<Integer>(box.size());
  Point sum{};
  for (const Point& point : box)
    for (std::size_t a = 0; a < 3; ++a) sum[a] += point[a];
  DacCode code;
  for (std::size_t a = 0; a < 3; ++a) {
    Integer numerator = sum[a], denominator = 31 * n;
    if (is.space == Space::hsv) {
      const Integer plane = box.front()[0];
      Integer w = 0;  // over hues
      if (plane < is.hues) {
        const std::array<Integer, 3> phase{5, 3, 1};
        const Integer k = (phase[a] * is.hues + 6 * plane) % (6 * is.hues);
        w = std::max<Integer>(0, std::min({k, 4 * is.hues - k, is.hues}));
      }
      denominator = (is.values - 1) * n * (is.saturations - 1) * n * is.hues;
      numerator = sum[2] * ((is.saturations - 1) * n * is.hues - sum[1] * w);
    }
    code[a] = static_cast<std::uint8_t>(nearest_integer(63 * numerator, denominator));
  }
  return code;
}

std::size_t longest_axis(const Pixels& box, Integer& length, Integer& low) {
  std::size_t best = 0;
  length = -1;
  for (std::size_t a = 0; a < 3; ++a) {
    Integer least = box[0][a], greatest = box[0][a];
    for (const Point& point : box) {
      least = std::min(least, point[a]);
      greatest = std::max(greatest, point[a]);
    }
    if (greatest - least > length) {
      best = a;
      length = greatest - least;
      low = least;
    }
  }
  return best;
}

Integer length_of(const Pixels& box) {
  Integer length = 0, low = 0;
  longest_axis(box, length, low);
  return length;
}

std::pair<Pixels, Pixels> halves(const Pixels& box) {
  Integer length = 0, low = 0;
  const std::size_t axis = longest_axis(box, length, low);
  Integer best = 0, best_miss = -1;
  for (Integer cut = low; cut < low + length; ++cut) {
    const Integer below = std::count_if(box.begin(), box.end(),
                                        [&](const Point& point) { return point[axis] <= cut; });
    const Integer miss = std::abs(2 * below - static_cast<Integer>(box.size()));
    if (best_miss < 0 || miss < best_miss) {
      best = cut;
      best_miss = miss;
    }
  }
  std::pair<Pixels, Pixels> parts;
  for (const Point& point : box)
    (point[axis] <= best ? parts.first : parts.second).push_back(point);
  return parts;
}

std::vector<DacCode> naive_median(const Pixels& all, std::size_t entries, const Setting& is) {
  std::list<Pixels> boxes;
  if (entries > 0) boxes.push_back(all);
  const auto split = [&](std::list<Pixels>::iterator box) {
    auto [lower, upper] = halves(*box);
    *box = std::move(lower);
    return std::next(boxes.insert(std::next(box), std::move(upper)));
  };
  for (bool any = true; any && boxes.size() < entries;) {
    any = false;
    if (is.split == SplitOrder::breadth) {
      for (auto box = boxes.begin(); box != boxes.end() && boxes.size() < entries;) {
        const bool can = length_of(*box) > 0;
        box = can ? split(box) : std::next(box);
        any = any || can;
      }
      continue;
    }
    auto best = boxes.end();
    for (auto box = boxes.begin(); box != boxes.end(); ++box) {
      if (length_of(*box) == 0) continue;
      const auto more = [&] {
        return is.split == SplitOrder::pixels ? box->size() > best->size()
                                              : length_of(*box) > length_of(*best);
      };
      if (best == boxes.end() || more()) best = box;
    }
    if (best == boxes.end()) break;
    split(best);
    any = true;
  }
  std::vector<DacCode> codes;
  for (const Pixels& box : boxes) codes.push_back(mean_code(box, is));
  return codes;
}

std::vector<DacCode> naive_frequency(const Pixels& all, std::size_t entries, const Setting& is) {
  std::map<Point, int> counts;
  for (const Point& point : all) ++counts[point];
  std::vector<DacCode> codes;
  while (codes.size() < entries && !counts.empty()) {
    auto best = counts.begin();
    for (auto at = counts.begin(); at != counts.end(); ++at)
      if (at->second > best->second) best = at;
    codes.push_back(mean_code({best->first}, is));
    counts.erase(best);
  }
  return codes;
}

std::size_t distinct(const Pixels& pixels) {
  std::map<Point, int> cells;
  for (const Point& point : pixels) cells[point] = 1;
  return cells.size();
}

/// Entries of each plane: the floors, then one at a time by largest remainder.
std::map<Integer, std::size_t> naive_shares(const std::map<Integer, Pixels>& planes) {
  std::size_t all = 0, given = 0;
  for (const auto& [number, pixels] : planes) all += distinct(pixels);
  std::map<Integer, std::size_t> shares, remainders;
  for (const auto& [number, pixels] : planes) {
    shares[number] = 256 * distinct(pixels) / all;
    remainders[number] = 256 * distinct(pixels) - shares[number] * all;
    given += shares[number];
  }
  for (; given < 256; ++given) {
    auto best = remainders.begin();
    for (auto at = remainders.begin(); at != remainders.end(); ++at) {
      const std::size_t pixels = planes.at(at->first).size();
      const std::size_t best_pixels = planes.at(best->first).size();
      if (at->second > best->second || (at->second == best->second && pixels > best_pixels))
        best = at;
    }
    ++shares[best->first];
    remainders.erase(best);
  }
  return shares;
}

std::vector<DacCode> naive_lut(const Planes& image, const Setting& is) {
  Pixels all;
  for (std::size_t i = 0; i < image.size.pixels(); ++i) {
    if (i % is.sample != 0) continue;
    const Rgb8 colour = image.at(i);
    all.push_back(is.space == Space::rgb ? Point{colour.r / 8, colour.g / 8, colour.b / 8}
                                         : hsv_point(colour, is));
  }
  std::vector<DacCode> codes;
  if (distinct(all) <= 256) {
    std::map<Point, int> cells;
    for (const Point& point : all) cells[point] = 1;
    for (const auto& [point, unused] : cells) codes.push_back(mean_code({point}, is));
  } else {
    std::map<Integer, Pixels> planes;
    for (const Point& point : all) planes[is.space == Space::rgb ? 0 : point[0]].push_back(point);
    const auto shares = naive_shares(planes);
    for (const auto& [number, pixels] : planes) {
      const auto part = is.method == Method::frequency
                            ? naive_frequency(pixels, shares.at(number), is)
                            : naive_median(pixels, shares.at(number), is);
      codes.insert(codes.end(), part.begin(), part.end());
    }
  }
  while (codes.size() < 256) codes.push_back(codes.back());
  return codes;
}

/// Small images of many kinds: kind 0 to 8.
Planes small_image(std::mt19937& random, int kind) {
  const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
  Planes image(kind == 0 ? ImageSize{2, 1} : ImageSize{20 + below(20), 20 + below(15)});
  const auto byte = [](int level) { return static_cast<std::uint8_t>(level); };
  const Rgb8 one{byte(below(256)), byte(below(256)), byte(below(256))};
  const std::size_t repeat = 1 + random() % 3;
  for (std::size_t i = 0; i < image.size.pixels(); ++i) {
    Rgb8 colour{byte(below(256)), byte(below(256)), byte(below(256))};
    const int low = below(6);
    switch (kind) {
      case 1: colour = one; break;
      case 2: colour.g = colour.b = colour.r; break;  // greys
      case 3: colour = {byte(below(3) * 120), byte(below(3) * 120), byte(below(2) * 255)}; break;
      case 4: colour = {byte(low * 51), byte(below(6) * 51), byte(below(8) * 36)}; break;  // ties
      case 5: colour = {colour.r, byte(colour.r / 4), byte(colour.g / 16)}; break;  // few hues
      case 6: colour = {byte(below(64)), byte(below(64)), byte(below(64))}; break;  // dark
      case 7: {  // 257 cells of the RGB grid, each `repeat` times or once more
        const auto cell = static_cast<int>(i / repeat % 257);
        colour = {byte(cell / 32 * 24), byte(cell % 32 * 8), 128};
        break;
      }
      default: break;  // noise
    }
    image.set(i, colour);
  }
  return image;
}

std::string compare(const Planes& image, const Setting& is) {
  ChooseOptions options;
  options.space = is.space;
  options.method = is.method;
  options.split = is.split;
  options.sample = is.sample;
  options.grid.hues = static_cast<int>(is.hues);
  options.grid.saturations = static_cast<int>(is.saturations);
  options.grid.values = static_cast<int>(is.values);
  options.grid.grey_s = static_cast<double>(is.grey_s_percent) / 100;
  options.grid.grey_v = static_cast<double>(is.grey_v_percent) / 100;
  const auto expected = naive_lut(image, is);
  const Lut lut = choose_lut(image, options);
  for (std::size_t i = 0; i < 256; ++i)
    if (lut.entry[i] != expected[i]) return "differs from entry " + std::to_string(i) + " on";
  return "equal";
}

const std::array kOrders{SplitOrder::pixels, SplitOrder::breadth, SplitOrder::longest};

TEST(Oracle, EveryMethodOnManySmallImages) {
  std::mt19937 random(1989);
  for (int round = 0; round < 15; ++round)
    for (int kind = 0; kind <= 8; ++kind) {
      const Planes image = small_image(random, kind);
      for (const Space space : {Space::rgb, Space::hsv}) {
        ASSERT_EQ(compare(image, {space, Method::frequency, SplitOrder::pixels}), "equal")
            << "frequency, round " << round << " kind " << kind;
        for (const SplitOrder split : kOrders)
          ASSERT_EQ(compare(image, {space, Method::median, split}), "equal")
              << "median, round " << round << " kind " << kind << " order "
              << static_cast<int>(split);
      }
    }
}

TEST(Oracle, OtherGridsLimitsAndSamples) {
  std::mt19937 random(34);
  for (int round = 0; round < 40; ++round) {
    const Planes image = small_image(random, 4 + round % 5);
    Setting is{Space::hsv, round % 4 == 0 ? Method::frequency : Method::median,
               kOrders[static_cast<std::size_t>(round) % 3]};
    const auto between = [&](Integer low, Integer high) {
      return low + static_cast<Integer>(random() % static_cast<unsigned>(high - low + 1));
    };
    is.hues = between(1, 72);
    is.saturations = between(2, 60);
    is.values = between(2, 60);
    is.grey_s_percent = between(0, 50);
    is.grey_v_percent = between(0, 50);
    is.sample = static_cast<std::size_t>(between(1, 2));
    ASSERT_EQ(compare(image, is), "equal") << "round " << round;
  }
}

}  // namespace
}  // namespace sir::quant
