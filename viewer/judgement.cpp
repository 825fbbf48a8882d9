#include "viewer/judgement.h"

#include <algorithm>

#include <fmt/format.h>

#include "quant/hue_loss.h"

namespace sir::viewer {
namespace {

constexpr int kDegreesAPlane = 10;

}  // namespace

std::optional<Judgement> judge(const Planes& reference, const Planes& shown, std::stop_token stop) {
  if (stop.stop_requested()) return std::nullopt;
  Judgement judgement;
  judgement.metrics = quant::measure(reference, shown);
  if (stop.stop_requested()) return std::nullopt;
  const quant::HueLoss loss = quant::hue_loss(reference, shown);
  for (const auto& plane : loss.planes) {
    if (!std::binary_search(loss.alarms.begin(), loss.alarms.end(), plane.plane)) continue;
    const int degrees = kDegreesAPlane * plane.plane;
    judgement.lost.push_back({degrees, quant::hue_name(degrees), plane.pixels, plane.lost});
  }
  if (stop.stop_requested()) return std::nullopt;
  return judgement;
}

std::vector<std::string> describe(const Judgement& judgement) {
  const quant::ImageMetrics& m = judgement.metrics;
  std::vector<std::string> lines{
      m.psnr ? fmt::format("PSNR {:.2f} dB · RMSE {:.3f}", *m.psnr, m.rmse)
             : std::string("PSNR infinite: equal to the true colours"),
      fmt::format("CIEDE2000 mean {:.3f} · 95 % {:.2f} · most {:.2f}", m.de_mean, m.de_p95,
                  m.de_max),
      fmt::format("SSIM {:.4f} · banding {:.4f}", m.ssim, m.banding),
      fmt::format("{} colours · hue loss {:.1f} %", m.colours, 100 * m.hue_loss)};
  for (const LostHue& hue : judgement.lost)
    lines.push_back(fmt::format("hue {}° ({}) is gone: {:.0f} % of {} pixels", hue.degrees,
                                hue.name, 100 * hue.lost, hue.pixels));
  return lines;
}

}  // namespace sir::viewer
