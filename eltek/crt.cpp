#include "eltek/crt.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include "eltek/light_shares.h"
#include "quant/lattice.h"

namespace sir::eltek {
namespace {

using quant::Light;

// 4/3 of 780 rows are 1040 columns, of which the screen has 1024.
constexpr int kAspectAcross = 65, kAspectDown = 64;

const CrtOptions& checked(const CrtOptions& options) {
  if (!options.valid()) throw std::invalid_argument("a tube that cannot be");
  return options;
}

std::vector<Light> palette_light(const Tube& tube, std::span<const Rgb8, 256> seen,
                                 const quant::DacBits& dac) {
  const quant::Lattice lattice(dac);  // a seen byte's nearest code is the one that it is seen of
  std::vector<Voltages> voltages;
  for (const Rgb8 colour : seen) {
    const quant::DacCode code = lattice.nearest(colour);
    Voltages& one = voltages.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) one[c] = code[c] / static_cast<double>(dac.max_code(c));
  }
  return tube.light_of(voltages);
}

void add(Light& sum, double weight, const Light& light) {
  for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * light[c];
}

// Of every stride-th of `light`.
Light mean(const LightShares& shares, std::span<const Light> light, std::size_t stride) {
  Light sum{};
  std::size_t at = static_cast<std::size_t>(shares.first) * stride;
  for (const double weight : shares.weight) {
    add(sum, weight, light[at]);
    at += stride;
  }
  return sum;
}

// What the rows of one line are multiplied by.
std::vector<double> line_light(const CrtOptions& options) {
  std::vector<double> light;
  for (int k = 0; k < options.scale; ++k) {
    const double place = (k + 0.5) / options.scale;
    light.push_back(1 - options.scan_lines * (1 + std::cos(2 * std::numbers::pi * place)) / 2);
  }
  return light;
}

}  // namespace

bool CrtOptions::valid() const {
  return tube.valid() && scale >= 1 && scale <= kMaxScale &&
         (spot == 0 || (spot >= kLeastSpot && spot <= kMaxSpot)) && scan_lines >= 0 &&
         scan_lines <= 1 && (scan_lines == 0 || scale >= kLeastScanLineScale);
}

bool CrtOptions::is_colour_map() const {
  return scale == 1 && !aspect && spot == 0 && scan_lines == 0;
}

Crt::Crt(const CrtOptions& options) : options_(checked(options)), tube_(options.tube) {}

std::array<Rgb8, 256> Crt::palette(std::span<const Rgb8, 256> seen,
                                   const quant::DacBits& dac) const {
  const std::vector<Light> light = palette_light(tube_, seen, dac);
  std::array<Rgb8, 256> colours;
  std::transform(light.begin(), light.end(), colours.begin(),
                 [](const Light& one) { return quant::LinearLight::table().colour(one); });
  return colours;
}

ImageSize Crt::shown_size(ImageSize picture) const {
  ImageSize shown{picture.width * options_.scale, picture.height * options_.scale};
  if (options_.aspect)
    shown.width = (2 * shown.width * kAspectAcross + kAspectDown) / (2 * kAspectDown);
  return shown;
}

Screen Crt::show(const IndexedScreen& screen) const {
  if (options_.is_colour_map()) {
    const std::array<Rgb8, 256> colours = palette(screen);
    Screen shown{screen.size, {}};
    shown.pixels.reserve(screen.indices.size());
    for (const std::uint8_t index : screen.indices) shown.pixels.push_back(colours[index]);
    return shown;
  }
  const std::vector<Light> entries = palette_light(tube_, screen.palette, screen.dac);
  std::vector<Light> light;
  light.reserve(screen.indices.size());
  for (const std::uint8_t index : screen.indices) light.push_back(entries[index]);
  return bytes_of(screen.size, light);
}

Screen Crt::show(const Screen& screen) const {
  // The three phosphors shine for themselves: their lights add up.
  std::vector<Voltages> voltages(3 * 256);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t byte = 0; byte < 256; ++byte)
      voltages[256 * c + byte][c] = static_cast<double>(byte) / 255;
  const std::vector<Light> alone = tube_.light_of(voltages);
  std::vector<Light> light;
  light.reserve(screen.pixels.size());
  for (const Rgb8 colour : screen.pixels) {
    Light sum = alone[colour.r];
    add(sum, 1, alone[256u + colour.g]);
    add(sum, 1, alone[512u + colour.b]);
    light.push_back(sum);
  }
  return bytes_of(screen.size, light);
}

Screen Crt::bytes_of(ImageSize size, const std::vector<Light>& light) const {
  const auto& table = quant::LinearLight::table();
  Screen shown{shown_size(size), {}};
  shown.pixels.reserve(shown.size.pixels());
  if (options_.is_colour_map()) {
    for (const Light& one : light) shown.pixels.push_back(table.colour(one));
    return shown;
  }
  const auto across = light_shares(size.width, shown.size.width, options_.spot);
  const auto down = light_shares(size.height, shown.size.height, options_.spot);
  const std::vector<double> of_line = line_light(options_);
  std::vector<Light> row(static_cast<std::size_t>(size.width));
  for (std::size_t j = 0; j < down.size(); ++j) {
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] = mean(down[j], std::span(light).subspan(i), row.size());
    for (Light& one : row)
      for (double& primary : one) primary *= of_line[j % of_line.size()];
    for (const LightShares& shares : across)
      shown.pixels.push_back(table.colour(mean(shares, row, 1)));
  }
  return shown;
}

}  // namespace sir::eltek
