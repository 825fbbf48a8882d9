#include "cli/report_svg.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace sir::cli {

std::string swatches_svg(const quant::Lut& lut, const std::string& label) {
  std::string svg = fmt::format(
      "<svg class=\"lut\" viewBox=\"0 0 160 160\" role=\"img\" aria-label=\"{}\">", label);
  for (std::size_t i = 0; i < lut.chosen; ++i) {
    const Rgb8 colour = lut.seen(i);
    const auto& code = lut.entry[i];
    fmt::format_to(std::back_inserter(svg),
                   "<rect x=\"{}\" y=\"{}\" width=\"10\" height=\"10\" "
                   "fill=\"#{:02x}{:02x}{:02x}\"><title>{}: {} {} {}</title></rect>",
                   i % 16 * 10, i / 16 * 10, colour.r, colour.g, colour.b, i, code[0], code[1],
                   code[2]);
  }
  return svg + "</svg>";
}

std::string clock_svg(const ClockReading& reading) {
  const quant::ClockFit fit = quant::fit_clock(reading.samples);
  constexpr double kSide = 360, kLeft = 44, kTop = 14, kMost = 180;
  const auto across = [&](double seconds) { return kLeft + seconds / kMost * kSide; };
  const auto up = [&](double seconds) { return kTop + kSide - seconds / kMost * kSide; };
  std::string svg = fmt::format(
      "<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" "
      "aria-label=\"seconds of 1989, measured and predicted\">",
      kLeft + kSide + 80, kTop + kSide + 44);
  auto out = std::back_inserter(svg);
  for (int tick = 0; tick <= 180; tick += 30) {
    fmt::format_to(out,
                   "<path class=\"grid\" d=\"M{0} {1}H{2}M{3} {4}V{5}\"/>"
                   "<text class=\"right\" x=\"{6}\" y=\"{7}\">{8}</text>"
                   "<text class=\"mid\" x=\"{3}\" y=\"{9}\">{8}</text>",
                   kLeft, up(tick), kLeft + kSide, across(tick), kTop, kTop + kSide, kLeft - 6,
                   up(tick) + 4, tick, kTop + kSide + 16);
  }
  fmt::format_to(out, "<path class=\"equal\" d=\"M{} {}L{} {}\"/>", across(0), up(0), across(kMost),
                 up(kMost));
  for (std::size_t i = 0; i < reading.samples.size(); ++i) {
    const auto& sample = reading.samples[i];
    const bool rgb = sample.space == quant::Space::rgb;
    const double x = across(sample.measured_seconds);
    const double y = up(std::min(fit.predicted[i], kMost));
    fmt::format_to(out,
                   "<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\">"
                   "<title>{} in {}: {:.0f} s in 1989, {:.1f} s predicted</title></circle>",
                   rgb ? "rgb" : "hsv", x, y, sample.image, rgb ? "RGB" : "HSV",
                   sample.measured_seconds, fit.predicted[i]);
    // The HSV points lie on one another, and so would their names; a name left of
    // its point keeps clear of them.
    if (rgb)
      fmt::format_to(out, "<text class=\"right\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", x - 8, y + 4,
                     sample.image);
  }
  fmt::format_to(out,
                 "<text class=\"mid\" x=\"{}\" y=\"{}\">seconds in 1989</text>"
                 "<text class=\"mid\" transform=\"translate(12 {}) rotate(-90)\">predicted</text>",
                 kLeft + kSide / 2, kTop + kSide + 36, kTop + kSide / 2);
  return svg + "</svg>";
}

}  // namespace sir::cli
