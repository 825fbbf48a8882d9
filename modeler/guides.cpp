#include "modeler/guides.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "modeler/screen_frame.h"

namespace sir::modeler {
namespace {

constexpr Rgb8 kAxis[]{{235, 80, 80}, {90, 210, 90}, {100, 140, 255}};
constexpr Rgb8 kEdge{255, 220, 120}, kGrid{120, 125, 135};
constexpr double kInFront = 0.85, kBehind = 0.22;

// A line that lies on the solid is not behind it: so much of the distance from the eye, or in
// parallel projection of the window, is between the ray through the pixel's centre and the line.
constexpr double kSlack = 0.005;

bool usable(const Box& box) {
  const glm::dvec3 extent = box.high - box.low;
  return !is_empty(box) && std::isfinite(extent.x + extent.y + extent.z);
}

// Where a line is on the screen: columns and rows in pixels, and what interpolates along it there.
struct Seen {
  double x, y;
  double depth;  // 1 / (Zf + z), or z in parallel projection
};

class Drawing {
 public:
  Drawing(const CameraFile& camera, ImageSize size, Picker* picker)
      : camera_(camera), frame_(camera), size_(size), picker_(picker) {}

  void add(const GuideLine& line, std::vector<GuidePixel>& pixels) {
    glm::dvec3 a = frame_.observe(line.from), b = frame_.observe(line.to);
    // Rays begin on the screen.
    if (a.z < 0 && b.z < 0) return;
    if (a.z < 0) a += (b - a) * (a.z / (a.z - b.z));
    else if (b.z < 0) b += (a - b) * (b.z / (b.z - a.z));
    Seen from = seen(a), to = seen(b);
    if (!std::isfinite(from.x + from.y + to.x + to.y) || !clip(from, to)) return;
    const double way = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    const int steps = std::max(1, static_cast<int>(std::ceil(way)));
    std::size_t last = std::numeric_limits<std::size_t>::max();
    for (int step = 0; step <= steps; ++step) {
      const double at = double(step) / steps;
      const int x = std::clamp(static_cast<int>(std::lerp(from.x, to.x, at)), 0, size_.width - 1);
      const int y = std::clamp(static_cast<int>(std::lerp(from.y, to.y, at)), 0, size_.height - 1);
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
          static_cast<std::size_t>(x);
      if (pixel == last) continue;
      last = pixel;
      const bool behind = is_behind(x, y, std::lerp(from.depth, to.depth, at));
      pixels.push_back({pixel, line.colour, behind ? kBehind : kInFront});
    }
  }

 private:
  Seen seen(const glm::dvec3& point) const {
    const double nearness = camera_.parallel ? 1 : 1 / (camera_.focal + point.z);
    const double shrink = camera_.parallel ? 1 : camera_.focal * nearness;
    return {(shrink * point.x / camera_.window.x + 0.5) * size_.width,
            (0.5 - shrink * point.y / camera_.window.y) * size_.height,
            camera_.parallel ? point.z : nearness};
  }

  // Cuts off what is outside the picture (Liang, Barsky 1984); false where that is all of it.
  bool clip(Seen& from, Seen& to) const {
    double enter = 0, leave = 1;
    const auto side = [&](double start, double way, double limit) {
      for (const auto& [p, q] : {std::pair{-way, start}, std::pair{way, limit - start}}) {
        if (p == 0 && q < 0) return false;
        if (p < 0) enter = std::max(enter, q / p);
        else if (p > 0) leave = std::min(leave, q / p);
      }
      return enter <= leave;
    };
    if (!side(from.x, to.x - from.x, size_.width) || !side(from.y, to.y - from.y, size_.height))
      return false;
    const auto along = [a = from, b = to](double at) {
      return Seen{std::lerp(a.x, b.x, at), std::lerp(a.y, b.y, at),
                  std::lerp(a.depth, b.depth, at)};
    };
    from = along(enter);
    to = along(leave);
    return true;
  }

  bool is_behind(int x, int y, double depth) {
    if (picker_ == nullptr) return false;
    const auto pick = picker_->at(x, y);
    if (!pick) return false;
    if (camera_.parallel) return depth > pick->t + kSlack * camera_.window.y;
    // A ray is as far from the eye as 1 + t, in units of its direction.
    return 1 / (depth * camera_.focal) > (1 + pick->t) * (1 + kSlack);
  }

  const CameraFile& camera_;
  ScreenFrame frame_;
  ImageSize size_;
  Picker* picker_;
};

}  // namespace

std::vector<GuideLine> axes(const Box& bounds) {
  double reach = 1;
  if (usable(bounds)) {
    reach = 0;
    for (int axis = 0; axis < 3; ++axis)
      reach = std::max({reach, std::abs(bounds.low[axis]), std::abs(bounds.high[axis])});
  }
  std::vector<GuideLine> lines;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 end(0);
    end[axis] = 1.25 * reach;  // beyond the solid's surface
    lines.push_back({glm::dvec3(0), end, kAxis[axis]});
  }
  return lines;
}

std::vector<GuideLine> edges(const Box& bounds) {
  std::vector<GuideLine> lines;
  if (!usable(bounds)) return lines;
  for (int axis = 0; axis < 3; ++axis)
    for (int corner = 0; corner < 4; ++corner) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      glm::dvec3 from = bounds.low;
      if ((corner & 1) != 0) from[u] = bounds.high[u];
      if ((corner & 2) != 0) from[v] = bounds.high[v];
      glm::dvec3 to = from;
      to[axis] = bounds.high[axis];
      lines.push_back({from, to, kEdge});
    }
  return lines;
}

std::vector<GuideLine> grid(const Box& bounds) {
  const Box box = usable(bounds) ? bounds : Box{glm::dvec3(-1), glm::dvec3(1)};
  const glm::dvec3 extent = box.high - box.low;
  const double tenth = std::max(extent.x, extent.z) / 10;
  std::vector<GuideLine> lines;
  if (!(tenth > std::numeric_limits<double>::min())) return lines;
  const double power = std::pow(10, std::floor(std::log10(tenth)));
  const double times = tenth / power;
  const double step = power * (times <= 1 ? 1 : times <= 2 ? 2 : times <= 5 ? 5 : 10);
  const auto below = [&](double at) { return (std::floor(at / step) - 1) * step; };
  const auto above = [&](double at) { return (std::ceil(at / step) + 1) * step; };
  const double x0 = below(box.low.x), x1 = above(box.high.x);
  const double z0 = below(box.low.z), z1 = above(box.high.z);
  const auto count = [&](double from, double to) {
    return static_cast<int>(std::lround((to - from) / step));
  };
  for (int i = 0; i <= count(x0, x1); ++i)
    lines.push_back({{x0 + i * step, 0, z0}, {x0 + i * step, 0, z1}, kGrid});
  for (int i = 0; i <= count(z0, z1); ++i)
    lines.push_back({{x0, 0, z0 + i * step}, {x1, 0, z0 + i * step}, kGrid});
  return lines;
}

std::vector<GuidePixel> pixels_of(const std::vector<GuideLine>& lines, const CameraFile& camera,
                                  ImageSize size, Picker* picker, const std::stop_token& stop) {
  std::vector<GuidePixel> pixels;
  Drawing drawing(camera, size, picker);
  for (const GuideLine& line : lines)
    if (!stop.stop_requested()) drawing.add(line, pixels);
  return pixels;
}

void draw(const std::vector<GuidePixel>& pixels, Planes& picture) {
  for (const GuidePixel& at : pixels)
    picture.set(at.pixel, mixed(picture.at(at.pixel), at.colour, at.share));
}

Rgb8 mixed(Rgb8 under, Rgb8 over, double share) {
  const auto mix = [share](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(std::lerp(double(a), double(b), share)));
  };
  return {mix(under.r, over.r), mix(under.g, over.g), mix(under.b, over.b)};
}

}  // namespace sir::modeler
