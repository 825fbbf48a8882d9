// Numbers of colour selection, against rational arithmetic and against inputs
// made to mislead.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <tuple>

#include "quant/allocation.h"
#include "quant/choose.h"
#include "quant/color_space.h"
#include "quant/nearest.h"
#include "tests/cases.h"

namespace sir::quant {
namespace {

__extension__ typedef __int128 Wide;

// The same inputs in every run, unless RC_PARAMS asks for others.
const std::string kParameters = "seed=1989 max_success=" + std::to_string(test::cases(300));
const bool kSeeded = ::setenv("RC_PARAMS", kParameters.c_str(), 0) == 0;

// Whether `got` is the double nearest to n / d, decided in integers: got is
// m 2^-e with m of 53 bits, so |n 2^e - m d| <= d / 2. For 0 <= n / d <= 360.
bool is_nearest(double got, int n, int d) {
  if (n == 0) return got == 0;
  int exponent = 0;
  const auto m = static_cast<std::int64_t>(std::ldexp(std::frexp(got, &exponent), 53));
  const Wide gap = (Wide{n} << (53 - exponent)) - Wide{m} * d;
  return 2 * gap <= d && -2 * gap <= d;
}

// Hue in degrees, times the chroma: six sectors between the largest and the
// smallest byte, 60 degrees each.
int degrees_times_chroma(int r, int g, int b) {
  const int max = std::max({r, g, b}), min = std::min({r, g, b}), c = max - min;
  if (c == 0) return 0;
  if (b == min && r == max) return 60 * (g - min);            // red to yellow
  if (b == min) return 120 * c - 60 * (r - min);              // yellow to green
  if (r == min && g == max) return 120 * c + 60 * (b - min);  // green to cyan
  if (r == min) return 240 * c - 60 * (g - min);              // cyan to blue
  if (b == max) return 240 * c + 60 * (r - min);              // blue to magenta
  return 360 * c - 60 * (b - min);                            // magenta to red
}

// Every colour there is: hue, saturation and value are the doubles nearest to
// the rational ones.
TEST(HsvOfEveryColour, IsTheNearestDoubleOfTheRational) {
  std::uint64_t wrong_h = 0, wrong_s = 0, wrong_v = 0;
  for (int r = 0; r < 256; ++r)
    for (int g = 0; g < 256; ++g)
      for (int b = 0; b < 256; ++b) {
        const int max = std::max({r, g, b}), min = std::min({r, g, b}), c = max - min;
        const int degrees = degrees_times_chroma(r, g, b);
        const Hsv hsv = hsv_of({static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                                static_cast<std::uint8_t>(b)});
        wrong_h += !is_nearest(hsv.h, degrees, std::max(c, 1));
        wrong_s += !is_nearest(hsv.s, c, std::max(max, 1));
        wrong_v += !is_nearest(hsv.v, max, 255);
      }
  EXPECT_EQ(wrong_h, 0u);
  EXPECT_EQ(wrong_s, 0u);
  EXPECT_EQ(wrong_v, 0u);
}

TEST(HsvOfEveryColour, LeadsBackToItsBytes) {
  std::uint64_t wrong = 0;
  const auto byte = [](double x) { return static_cast<int>(std::floor(255 * x + 0.5)); };
  for (int r = 0; r < 256; ++r)
    for (int g = 0; g < 256; ++g)
      for (int b = 0; b < 256; ++b) {
        const Rgb back =
            hsv_to_rgb(hsv_of({static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                               static_cast<std::uint8_t>(b)}));
        wrong += byte(back.r) != r || byte(back.g) != g || byte(back.b) != b;
      }
  EXPECT_EQ(wrong, 0u);
}

// Bins of other grids, every colour of a coarser net and the borders of bytes:
// the bin i of n levels has i - 1/2 <= (n-1) x < i + 1/2.
TEST(HsvBins, AreExactInGridsOfAnyShape) {
  for (const char* const text : {"36x30x30", "1x2x2", "7x11x13", "250x256x256", "97x101x103"}) {
    HsvGridShape shape;
    ASSERT_TRUE(parse_grid(text, shape));
    shape.grey_s = shape.grey_v = 0;
    const HsvGrid grid(shape);
    std::uint64_t wrong = 0;
    for (int r = 0; r < 256; r += 3)
      for (int g = 0; g < 256; g += 5)
        for (int b = 0; b < 256; ++b) {
          const int max = std::max({r, g, b}), c = max - std::min({r, g, b});
          const GridPoint at =
              grid.point(grid.cell({static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                                    static_cast<std::uint8_t>(b)}));
          const auto in_bin = [](int bin, int levels, int n, int d) {
            return (2 * bin - 1) * d <= 2 * (levels - 1) * n &&
                   2 * (levels - 1) * n < (2 * bin + 1) * d;
          };
          wrong += !in_bin(at[2], shape.values, max, 255);
          wrong += (c == 0) != (at[0] == shape.hues);
          if (c == 0) continue;
          wrong += !in_bin(at[1], shape.saturations, c, max);
          // Bins of hue are centred on 360 i / hues; what is past the last one
          // belongs to bin 0.
          const int twice = 2 * shape.hues * degrees_times_chroma(r, g, b);
          const int bin = at[0] == 0 && twice >= 360 * c ? shape.hues : at[0];
          wrong += !((2 * bin - 1) * 360 * c <= twice && twice < (2 * bin + 1) * 360 * c);
        }
    EXPECT_EQ(wrong, 0u) << text;
  }
}

// Largest remainders by sorting exact fractions.
std::vector<std::size_t> exact_shares(std::size_t entries, const std::vector<PlaneClaim>& planes) {
  using boost::multiprecision::cpp_int;
  cpp_int all = 0;
  for (const PlaneClaim& plane : planes) all += plane.cells;
  std::vector<std::size_t> shares;
  if (all <= entries) {
    for (const PlaneClaim& plane : planes) shares.push_back(plane.cells);
    return shares;
  }
  std::multimap<std::tuple<cpp_int, std::uint64_t, std::size_t>, std::size_t> claims;
  std::size_t given = 0;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const cpp_int quota = cpp_int(entries) * planes[p].cells;
    shares.push_back(static_cast<std::size_t>(quota / all));
    given += shares.back();
    claims.emplace(std::make_tuple(cpp_int(quota % all), planes[p].pixels, planes.size() - p), p);
  }
  for (auto claim = claims.rbegin(); given < entries; ++claim, ++given) ++shares[claim->second];
  return shares;
}

bool shares_are_right(std::size_t entries, const std::vector<PlaneClaim>& planes) {
  const auto shares = allocate(entries, planes);
  std::size_t all = 0;
  for (const PlaneClaim& plane : planes) all += plane.cells;
  const auto sum = std::accumulate(shares.begin(), shares.end(), std::size_t{0});
  return sum == std::min(entries, all) && shares == exact_shares(entries, planes);
}

TEST(Allocation, AddsUpForAnyClaims) {
  ASSERT_TRUE(kSeeded);
  EXPECT_TRUE(rc::check("largest remainders", [] {
    // From single cells to as many as the largest grid has.
    const auto most = *rc::gen::element<std::size_t>(2, 9, 300, 27000, std::size_t{1} << 24);
    const auto claims = *rc::gen::container<std::vector<std::pair<std::size_t, std::uint64_t>>>(
        rc::gen::pair(rc::gen::inRange<std::size_t>(0, most), rc::gen::arbitrary<std::uint64_t>()));
    std::vector<PlaneClaim> planes;
    for (const auto& [cells, pixels] : claims) planes.push_back({cells, pixels});
    RC_ASSERT(shares_are_right(256, planes));
    const auto entries = *rc::gen::inRange<std::size_t>(0, 300);
    RC_ASSERT(shares_are_right(entries, planes));
  }));
}

TEST(Allocation, Extremes) {
  const std::size_t huge = HsvGridShape::kMaxCells;
  const std::uint64_t many = std::numeric_limits<std::uint64_t>::max();
  for (const std::size_t planes : {1u, 2u, 36u, 37u, 255u, 256u, 257u, 1025u})
    for (const std::size_t cells : {std::size_t{1}, std::size_t{2}, std::size_t{900}, huge}) {
      std::vector<PlaneClaim> claims(planes, {cells, 1});
      EXPECT_TRUE(shares_are_right(256, claims)) << planes << " of " << cells;
      claims.back() = {huge, many};  // one takes nearly all
      EXPECT_TRUE(shares_are_right(256, claims)) << planes << " of " << cells << ", one huge";
      claims.front() = {0, 0};
      EXPECT_TRUE(shares_are_right(256, claims)) << planes << " of " << cells << ", one empty";
    }
}

// Cells made to tie: equal counts, equal lengths of axes, symmetric places.
std::vector<Cell> tying_cells(int kind) {
  std::vector<Cell> cells;
  const auto add = [&](int r, int g, int b, std::uint64_t pixels) {
    cells.push_back({{r, g, b}, pixels});
  };
  for (int i = 0; i < 32; ++i)
    for (int j = 0; j < 32; ++j) {
      if (kind == 0) add(i, j, 0, 1);                                 // a square
      if (kind == 1 && i < 10 && j < 10) add(i, j, (i + j) % 10, 7);  // all axes alike
      if (kind == 2) add(i, j, i ^ j, (i + j) % 2 ? 1 : 1000000);     // two heights
      if (kind == 3 && j == 0) add(i, i, i, 1);                       // a diagonal
      if (kind == 4 && j == 0) add(i, 31 - i, 16, std::uint64_t{1} << i);
      if (kind == 5 && (i % 31 == 0 || j % 31 == 0)) add(i, j, 31 - i, 3);  // a frame
      if (kind == 6 && j < 2) add(31 * j, i, 31 - 31 * j, 1);               // two far rows
    }
  return cells;
}

TEST(MedianCut, OfTyingCellsIsTheSameInAnyOrder) {
  std::mt19937 random(21);
  const RgbGrid grid;
  for (int kind = 0; kind <= 6; ++kind)
    for (const SplitOrder order : {SplitOrder::pixels, SplitOrder::breadth, SplitOrder::longest})
      for (const std::size_t entries : {2u, 3u, 17u, 255u, 256u}) {
        auto cells = tying_cells(kind);
        const auto codes = median_cut(cells, entries, order, grid);
        EXPECT_EQ(codes.size(), std::min(entries, cells.size())) << kind;
        const auto same = [&] { return median_cut(cells, entries, order, grid) == codes; };
        std::reverse(cells.begin(), cells.end());
        EXPECT_TRUE(same()) << kind << " reversed";
        for (std::size_t axis = 0; axis < 3; ++axis) {
          std::stable_sort(cells.begin(), cells.end(),
                           [&](const Cell& a, const Cell& b) { return a.at[axis] > b.at[axis]; });
          EXPECT_TRUE(same()) << kind << " falling on axis " << axis;
        }
        for (int n = 0; n < 3; ++n) {
          std::shuffle(cells.begin(), cells.end(), random);
          EXPECT_TRUE(same()) << kind << " shuffled";
        }
      }
}

TEST(MedianCut, OfRandomCellsIsTheSameInAnyOrder) {
  EXPECT_TRUE(rc::check("median cut of a set of cells", [] {
    using Place = std::tuple<int, int, int>;
    const auto level = rc::gen::inRange(0, 32);
    const auto set = *rc::gen::container<std::map<Place, int>>(rc::gen::tuple(level, level, level),
                                                               rc::gen::inRange(1, 5));
    std::vector<Cell> cells;
    for (const auto& [place, pixels] : set) {
      const auto [r, g, b] = place;
      cells.push_back({{r, g, b}, static_cast<std::uint64_t>(pixels)});
    }
    auto shuffled = cells;
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    const auto entries = *rc::gen::inRange<std::size_t>(1, 40);
    const auto order =
        *rc::gen::element(SplitOrder::pixels, SplitOrder::breadth, SplitOrder::longest);
    const RgbGrid grid;
    const auto codes = median_cut(cells, entries, order, grid);
    RC_ASSERT(codes == median_cut(shuffled, entries, order, grid));
    RC_ASSERT(codes.size() == std::min(entries, cells.size()));
  }));
}

// LUTs made to mislead a search that leaves entries out.
std::vector<std::pair<std::string, std::vector<DacCode>>> misleading_luts() {
  std::vector<std::pair<std::string, std::vector<DacCode>>> luts;
  const auto code = [](int r, int g, int b) {
    return DacCode{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                   static_cast<std::uint8_t>(b)};
  };
  luts.push_back({"all equal", std::vector<DacCode>(256, code(31, 32, 33))});
  luts.push_back({"black and white", {code(0, 0, 0), code(63, 63, 63)}});
  luts.push_back({"white and black", {code(63, 63, 63), code(0, 0, 0)}});
  std::vector<DacCode> last(256, code(0, 0, 0));
  last[255] = code(63, 63, 63);
  luts.push_back({"only the last differs", last});
  std::vector<DacCode> first(256, code(63, 63, 63));
  first[0] = code(0, 0, 0);
  luts.push_back({"only the first differs", first});
  std::vector<DacCode> pairs, corners, greys, near, shell;
  for (int i = 0; i < 256; ++i) {
    pairs.push_back(code(i / 2 % 64, 63 - i / 2 % 64, i / 2 / 2 % 64));
    corners.push_back(code(i & 1 ? 63 : 0, i & 2 ? 63 : 0, i & 4 ? 63 : 0));
    greys.push_back(code(i / 4, i / 4, i / 4));
    near.push_back(code(30 + i % 6, 30 + i / 6 % 6, 30 + i / 36 % 8));
    shell.push_back(code(i % 2 * 63, i / 2 % 12 * 63 / 11, i / 24 * 63 / 11));
  }
  luts.push_back({"each twice", pairs});
  luts.push_back({"corners, many times", corners});
  luts.push_back({"greys, four times", greys});
  luts.push_back({"a lump", near});
  luts.push_back({"two faces", shell});
  std::reverse(shell.begin(), shell.end());
  luts.push_back({"two faces, reversed", shell});
  return luts;
}

TEST(NearestSearch, EqualsTheDefinitionOnMisleadingLuts) {
  for (const auto& [name, codes] : misleading_luts()) {
    const Lut lut = make_lut(codes);
    // Everywhere on a net, and one by one around what the entries are seen as.
    Planes image(ImageSize{64 * 64, 64 + 8});
    std::mt19937 random(22);
    for (std::size_t p = 0; p < image.size.pixels(); ++p) {
      Rgb8 colour{static_cast<std::uint8_t>(p % 64 * 255 / 63),
                  static_cast<std::uint8_t>(p / 64 % 64 * 255 / 63),
                  static_cast<std::uint8_t>(p / 4096 % 64 * 255 / 63)};
      if (p >= 64 * 64 * 64) {
        const Rgb8 entry = seen(lut.entry[random() % 256]), other = seen(lut.entry[random() % 256]);
        const auto between = [&](std::uint8_t a, std::uint8_t b) {
          const int middle = (a + b) / 2 + static_cast<int>(random() % 3) - 1;
          return static_cast<std::uint8_t>(std::clamp(middle, 0, 255));
        };
        colour = {between(entry.r, other.r), between(entry.g, other.g), between(entry.b, other.b)};
      }
      image.set(p, colour);
    }
    EXPECT_EQ(map_to_lut(image, lut), map_exhaustively(image, lut)) << name;
  }
}

TEST(NearestSearch, EqualsTheDefinitionOnAnyLut) {
  EXPECT_TRUE(rc::check("nearest entry", [] {
    const auto levels = *rc::gen::inRange(1, 65);
    const auto codes = *rc::gen::resize(
        300,
        rc::gen::container<std::vector<DacCode>>(rc::gen::container<DacCode>(rc::gen::map(
            rc::gen::inRange(0, levels), [](int e) { return static_cast<std::uint8_t>(e); }))));
    RC_PRE(!codes.empty() && codes.size() <= kLutEntries);
    const Lut lut = make_lut(codes);
    NearestSearch search(lut);
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    for (int n = 0; n < 500; ++n) {
      const auto byte = [&] { return static_cast<std::uint8_t>(random() >> 24); };
      const Rgb8 colour{byte(), byte(), byte()};
      RC_ASSERT(search(colour) == nearest_entry(colour, lut));
    }
  }));
}

}  // namespace
}  // namespace sir::quant
