#include "tracer/sample_adaptive.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <unordered_map>

namespace sir {
namespace {

// A corner of squares: steps of the finest level's side from the region's top left.
struct LatticePoint {
  std::int64_t x, y;
  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
};

struct Square {
  LatticePoint low;            // its top left corner
  std::uint32_t pixel;         // of the rectangle, to which it belongs
  std::array<Rgb8, 4> corner;  // top left, top right, bottom left, bottom right
};

// A new point that a divided square waits for: 0 top, 1 left, 2 centre, 3 right, 4 bottom.
struct Need {
  LatticePoint point;
  std::uint32_t slot;  // 5 * square + which
  friend bool operator<(const Need& a, const Need& b) {
    return a.point.y != b.point.y ? a.point.y < b.point.y : a.point.x < b.point.x;
  }
};

int spread(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) {
  const auto [least, most] = std::minmax({a, b, c, d});
  return most - least;
}

int difference(const std::array<Rgb8, 4>& k) {
  return std::max({spread(k[0].r, k[1].r, k[2].r, k[3].r), spread(k[0].g, k[1].g, k[2].g, k[3].g),
                   spread(k[0].b, k[1].b, k[2].b, k[3].b)});
}

// The samples on one line between two rectangles, by the other coordinate.
using Line = std::unordered_map<std::int64_t, Rgb8>;

class Adaptive {
 public:
  Adaptive(const Region& region, const AntialiasOptions& options, const SampleSource& source,
           Planes& planes, AntialiasCounts& counts)
      : region_(region),
        options_(options),
        source_(source),
        planes_(planes),
        counts_(counts),
        steps_(std::int64_t{1} << options.levels) {
    counts_.divided.resize(static_cast<std::size_t>(options.levels));
  }

  bool run() {
    // As square as can be with so many pixels: a rectangle's border is shared.
    const int pixels = std::clamp(1 << (22 - 2 * options_.levels), 1 << 10, 1 << 16);
    const int side = 1 << (std::bit_width(static_cast<unsigned>(pixels)) - 1) / 2;
    int height = std::min(region_.height, side);
    const int width = std::min(region_.width, pixels / height);
    height = std::min(region_.height, pixels / width);
    const int across = (region_.width + width - 1) / width;
    const int down = (region_.height + height - 1) / height;
    for (int row = 0; row < down; ++row) {
      left_.clear();
      for (int column = 0; column < across; ++column) {
        const double all = double(across) * down, done = double(row) * across + column;
        share_ = {done / all, (done + 1) / all};
        const int x = column * width, y = row * height;
        if (!rectangle(
                {x, y, std::min(width, region_.width - x), std::min(height, region_.height - y)}))
          return false;
        left_ = std::move(right_);
        right_.clear();
      }
      above_ = std::move(below_);
      below_.clear();
    }
    return true;
  }

 private:
  bool rectangle(const Region& pixels) {
    low_ = {pixels.x * steps_, pixels.y * steps_};
    high_ = {low_.x + pixels.width * steps_, low_.y + pixels.height * steps_};
    sums_.assign(static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height),
                 {});
    if (!whole_pixels(pixels)) return false;
    std::int64_t side = steps_;
    for (int level = 0; !squares_.empty(); ++level, side /= 2) {
      keep_differing(level, side);
      if (!squares_.empty() && !divide(level, side)) return false;
    }
    // The weights of a pixel's corners add up to this.
    const auto weights = static_cast<std::uint32_t>(4 * steps_ * steps_);
    const auto mean = [&](std::uint32_t sum) {
      return static_cast<std::uint8_t>((sum + weights / 2) / weights);
    };
    for (std::size_t p = 0; p < sums_.size(); ++p) {
      const auto width = static_cast<std::size_t>(pixels.width);
      const std::size_t i = static_cast<std::size_t>(pixels.x) + p % width;
      const std::size_t j = static_cast<std::size_t>(pixels.y) + p / width;
      planes_.set(j * static_cast<std::size_t>(region_.width) + i,
                  {mean(sums_[p][0]), mean(sums_[p][1]), mean(sums_[p][2])});
    }
    return true;
  }

  // The squares of level 0.
  bool whole_pixels(const Region& pixels) {
    wanted_.clear();
    for (std::int64_t y = low_.y; y <= high_.y; y += steps_)
      for (std::int64_t x = low_.x; x <= high_.x; x += steps_) wanted_.push_back({x, y});
    if (!fetch(0)) return false;
    squares_.clear();
    const auto width = static_cast<std::size_t>(pixels.width);
    for (std::size_t p = 0; p < sums_.size(); ++p) {
      const std::size_t at = p / width * (width + 1) + p % width;
      squares_.push_back(
          {wanted_[at],
           static_cast<std::uint32_t>(p),
           {seen_[at], seen_[at + 1], seen_[at + width + 1], seen_[at + width + 2]}});
    }
    return true;
  }

  // Adds the squares that are not to be divided to their pixels and drops them.
  void keep_differing(int level, std::int64_t side) {
    const auto weight = static_cast<std::uint32_t>(side * side);
    const auto settled = [&](const Square& square) {
      if (level < options_.levels && difference(square.corner) > options_.threshold) return false;
      auto& sum = sums_[square.pixel];
      for (const Rgb8& corner : square.corner) {
        sum[0] += weight * corner.r;
        sum[1] += weight * corner.g;
        sum[2] += weight * corner.b;
      }
      return true;
    };
    std::erase_if(squares_, settled);
  }

  // Divides all squares, which have this side.
  bool divide(int level, std::int64_t side) {
    counts_.divided[static_cast<std::size_t>(level)] += squares_.size();
    const std::int64_t half = side / 2;
    needs_.clear();
    for (std::uint32_t s = 0; s < squares_.size(); ++s) {
      const auto [x, y] = squares_[s].low;
      needs_.push_back({{x + half, y}, 5 * s});
      needs_.push_back({{x, y + half}, 5 * s + 1});
      needs_.push_back({{x + half, y + half}, 5 * s + 2});
      needs_.push_back({{x + side, y + half}, 5 * s + 3});
      needs_.push_back({{x + half, y + side}, 5 * s + 4});
    }
    // Points of different levels never coincide; those of one level do where two
    // squares meet.
    std::sort(needs_.begin(), needs_.end());
    wanted_.clear();
    for (const Need& need : needs_)
      if (wanted_.empty() || wanted_.back() != need.point) wanted_.push_back(need.point);
    if (!fetch(level + 1)) return false;

    new_points_.resize(squares_.size() * 5);
    std::size_t at = 0;
    for (const Need& need : needs_) {
      if (wanted_[at] != need.point) ++at;
      new_points_[need.slot] = seen_[at];
    }
    parts_.clear();
    for (std::size_t s = 0; s < squares_.size(); ++s) {
      const auto& [low, pixel, k] = squares_[s];
      const Rgb8* m = &new_points_[5 * s];
      parts_.push_back({low, pixel, {k[0], m[0], m[1], m[2]}});
      parts_.push_back({{low.x + half, low.y}, pixel, {m[0], k[1], m[2], m[3]}});
      parts_.push_back({{low.x, low.y + half}, pixel, {m[1], m[2], k[2], m[4]}});
      parts_.push_back({{low.x + half, low.y + half}, pixel, {m[2], m[3], m[4], k[3]}});
    }
    squares_.swap(parts_);
    return true;
  }

  // The samples seen_ of the points wanted_: those known from the rectangles above and
  // to the left, the others from the source.
  bool fetch(int level) {
    seen_.resize(wanted_.size());
    points_.clear();
    places_.clear();
    for (std::size_t p = 0; p < wanted_.size(); ++p) {
      if (known(wanted_[p], seen_[p])) continue;
      places_.push_back(p);
      points_.push_back({region_.x + double(wanted_[p].x) / double(steps_),
                         region_.y + double(wanted_[p].y) / double(steps_)});
    }
    traced_.resize(points_.size());
    const double part = (share_.to - share_.from) / (options_.levels + 1);
    const double from = share_.from + level * part;
    if (!source_(points_, traced_, {from, from + part})) return false;
    counts_.points += points_.size();
    for (std::size_t n = 0; n < places_.size(); ++n) seen_[places_[n]] = traced_[n];
    for (std::size_t p = 0; p < wanted_.size(); ++p) {
      if (wanted_[p].x == high_.x) right_.emplace(wanted_[p].y, seen_[p]);
      if (wanted_[p].y == high_.y) below_.emplace(wanted_[p].x, seen_[p]);
    }
    return true;
  }

  bool known(const LatticePoint& point, Rgb8& colour) const {
    const auto look_up = [&](const Line& line, std::int64_t at) {
      const auto found = line.find(at);
      if (found != line.end()) colour = found->second;
      return found != line.end();
    };
    return (point.y == low_.y && look_up(above_, point.x)) ||
           (point.x == low_.x && look_up(left_, point.y));
  }

  const Region region_;
  const AntialiasOptions options_;
  const SampleSource& source_;
  Planes& planes_;
  AntialiasCounts& counts_;
  const std::int64_t steps_;  // of the lattice along a pixel's side

  Share share_;                                     // of the rectangle
  LatticePoint low_{}, high_{};                     // its corners
  std::vector<std::array<std::uint32_t, 3>> sums_;  // of its pixels
  Line above_, left_, right_, below_;

  // Kept between levels and rectangles for their memory.
  std::vector<Square> squares_, parts_;
  std::vector<Need> needs_;
  std::vector<LatticePoint> wanted_;
  std::vector<Rgb8> seen_, traced_, new_points_;
  std::vector<ScreenPoint> points_;
  std::vector<std::size_t> places_;
};

}  // namespace

bool sample_adaptive(const Region& region, const AntialiasOptions& options,
                     const SampleSource& source, Planes& planes, AntialiasCounts& counts) {
  planes = Planes(ImageSize{region.width, region.height});
  return Adaptive(region, options, source, planes, counts).run();
}

}  // namespace sir
