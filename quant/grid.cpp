#include "quant/grid.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "quant/color_space.h"

namespace sir::quant {
namespace {

__extension__ typedef __int128 Wide;

/// floor(63 n / d + 1/2) for 0 <= n <= d.
std::uint8_t rounded_code(Wide numerator, Wide denominator) {
  return static_cast<std::uint8_t>((2 * kMaxCode * numerator + denominator) / (2 * denominator));
}

}  // namespace

void PointSum::add(const GridPoint& point, std::uint64_t times) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    sum[axis] += static_cast<std::uint64_t>(point[axis]) * times;
  pixels += times;
}

RgbGrid::RgbGrid(int bits) : bits_(bits) {
  if (bits < 1 || bits > kMaxBits) throw std::invalid_argument("an RGB grid of impossible bits");
}

std::size_t RgbGrid::size() const { return std::size_t{1} << 3 * bits_; }

std::size_t RgbGrid::cell(Rgb8 colour) const {
  const int lost = 8 - bits_;
  return static_cast<std::size_t>(colour.r) >> lost << 2 * bits_ |
         static_cast<std::size_t>(colour.g) >> lost << bits_ |
         static_cast<std::size_t>(colour.b) >> lost;
}

void RgbGrid::locate(const std::uint8_t* r, const std::uint8_t* g, const std::uint8_t* b,
                     std::span<std::uint32_t> cells) const {
  const auto locate_all = [&](const int bits) {
    const int lost = 8 - bits;
    for (std::size_t i = 0; i < cells.size(); ++i)
      cells[i] = static_cast<std::uint32_t>(r[i]) >> lost << 2 * bits |
                 static_cast<std::uint32_t>(g[i]) >> lost << bits |
                 static_cast<std::uint32_t>(b[i]) >> lost;
  };
  if (bits_ == kBits) locate_all(kBits);  // inlined with the number known
  else locate_all(bits_);
}

GridPoint RgbGrid::point(std::size_t cell) const {
  const std::size_t last = (std::size_t{1} << bits_) - 1;
  return {static_cast<int>(cell >> 2 * bits_), static_cast<int>(cell >> bits_ & last),
          static_cast<int>(cell & last)};
}

DacCode RgbGrid::code(const PointSum& mean) const {
  const Wide whole = static_cast<Wide>(mean.pixels) * ((1 << bits_) - 1);
  return {rounded_code(mean.sum[0], whole), rounded_code(mean.sum[1], whole),
          rounded_code(mean.sum[2], whole)};
}

bool HsvGridShape::valid() const {
  const auto between = [](auto low, auto x, auto high) { return low <= x && x <= high; };
  return between(1, hues, kMaxLevels) && between(2, saturations, kMaxLevels) &&
         between(2, values, kMaxLevels) && std::int64_t{hues} * saturations * values <= kMaxCells &&
         between(0.0, grey_s, 1.0) && between(0.0, grey_v, 1.0);
}

bool parse_grid(std::string_view text, HsvGridShape& shape) {
  HsvGridShape read = shape;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int* const levels : {&read.hues, &read.saturations, &read.values}) {
    if (levels != &read.hues && (at == end || (*at++ | 0x20) != 'x')) return false;
    const auto [stop, failure] = std::from_chars(at, end, *levels);
    if (failure != std::errc{}) return false;
    at = stop;
  }
  if (at != end || !read.valid()) return false;
  shape = read;
  return true;
}

HsvGrid::HsvGrid(const HsvGridShape& shape) : shape_(shape) {
  if (!shape.valid()) throw std::invalid_argument("an HSV grid of impossible shape");
  first_grey_ = shape.hues * shape.saturations * shape.values;
  // A quotient of two bytes is compared with the limit as its nearest double.
  // The limit is the double nearest to the decimal that was meant, so equal
  // stays equal. The largest saturation that is grey then decides for all.
  for (int max = 1; max <= 255; ++max) {
    if (static_cast<double>(max) / 255 <= shape.grey_v) grey_value_ = max;
    for (int chroma = 0; chroma <= max; ++chroma)
      if (static_cast<double>(chroma) / max <= shape.grey_s &&
          chroma * grey_max_ > grey_chroma_ * max) {
        grey_chroma_ = chroma;
        grey_max_ = max;
      }
  }
}

std::size_t HsvGrid::size() const {
  return static_cast<std::size_t>(first_grey_) + static_cast<std::size_t>(shape_.values);
}

std::size_t HsvGrid::cell(Rgb8 colour) const {
  const auto [max, chroma, sixth] = hexagon_of(colour);
  const int v = (2 * (shape_.values - 1) * max + 255) / 510;
  if (chroma * grey_max_ <= grey_chroma_ * max || max <= grey_value_)
    return static_cast<std::size_t>(first_grey_ + v);
  const int s = (2 * (shape_.saturations - 1) * chroma + max) / (2 * max);
  // The bins are centred on multiples of 360/hues, so the last half belongs to bin 0.
  const int h = (sixth * shape_.hues + 3 * chroma) / (6 * chroma) % shape_.hues;
  return static_cast<std::size_t>((h * shape_.saturations + s) * shape_.values + v);
}

void HsvGrid::locate(const std::uint8_t* red, const std::uint8_t* green, const std::uint8_t* blue,
                     std::span<std::uint32_t> cells) const {
  // The same as cell() without a branch and in floats, which every processor
  // multiplies and divides four or more at a time. It is exact: all whole
  // numbers stay below 2^24, and a quotient (below 1025) that is not whole is
  // at least 1/1530 short of the next integer, which is many roundings away.
  const auto hues = static_cast<float>(shape_.hues);
  const auto saturations = static_cast<float>(shape_.saturations);
  const auto values = static_cast<float>(shape_.values);
  const auto grey_chroma = static_cast<float>(grey_chroma_);
  const auto grey_max = static_cast<float>(grey_max_);
  const int grey_value = grey_value_, first_grey = first_grey_, last_hue = shape_.hues - 1;
  std::uint32_t* const out = cells.data();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int r = red[i], g = green[i], b = blue[i];
    const int max = std::max(std::max(r, g), b);
    const int chroma = max - std::min(std::min(r, g), b);
    const int from_red = g - b, from_green = 2 * chroma + b - r, from_blue = 4 * chroma + r - g;
    const int past_red = g == max ? from_green : from_blue;
    const int turned = r == max ? from_red : past_red;
    const auto sixth = static_cast<float>(turned + (-(turned < 0) & (6 * chroma)));
    const auto c = static_cast<float>(chroma), m = static_cast<float>(max);
    const auto twice_m = static_cast<float>(2 * max + (max == 0));  // nothing divides by 0
    const auto six_c = static_cast<float>(6 * chroma + (chroma == 0));
    const int v = static_cast<int>(((2 * values - 2) * m + 255) / 510);
    const int s = static_cast<int>(((2 * saturations - 2) * c + m) / twice_m);
    const int wrapped = static_cast<int>((sixth * hues + 3 * c) / six_c);
    const int h = wrapped & -(wrapped <= last_hue);
    const int grey = -((c * grey_max <= grey_chroma * m) | (max <= grey_value));
    const int column =
        static_cast<int>((static_cast<float>(h) * saturations + static_cast<float>(s)) * values);
    out[i] = static_cast<std::uint32_t>(((first_grey & grey) | (column & ~grey)) + v);
  }
}

GridPoint HsvGrid::point(std::size_t cell) const {
  const auto number = static_cast<int>(cell);
  if (number >= first_grey_) return {shape_.hues, 0, number - first_grey_};
  const int column = number / shape_.values;
  return {column / shape_.saturations, column % shape_.saturations, number % shape_.values};
}

DacCode HsvGrid::code(const PointSum& mean) const {
  const Wide pixels = mean.pixels;
  const Wide s = mean.sum[1], s_whole = pixels * (shape_.saturations - 1);
  const Wide v = mean.sum[2], v_whole = pixels * (shape_.values - 1);
  const auto plane = static_cast<int>(mean.sum[0] / mean.pixels);
  if (plane == grey_plane()) {
    const std::uint8_t level = rounded_code(v, v_whole);
    return {level, level, level};
  }
  // hsv_to_rgb over common denominators: the primary v (1 - s w / hues).
  const auto primary = [&](int w) {
    return rounded_code(v * (s_whole * shape_.hues - s * w), v_whole * s_whole * shape_.hues);
  };
  const int f = 6 * plane % shape_.hues;
  const std::uint8_t full = primary(0), p = primary(shape_.hues), q = primary(f),
                     t = primary(shape_.hues - f);
  switch (6 * plane / shape_.hues) {
    case 0: return {full, t, p};
    case 1: return {q, full, p};
    case 2: return {p, full, t};
    case 3: return {p, q, full};
    case 4: return {t, p, full};
    default: return {full, p, q};
  }
}

}  // namespace sir::quant
