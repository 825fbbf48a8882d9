#include "cli/monitor_options.h"

#include <array>
#include <memory>
#include <vector>

#include "quant/linear_light.h"

namespace sir::cli {
namespace {

using eltek::CrtOptions;
using eltek::PhosphorSet;
using eltek::WhitePoint;

struct Asked {
  bool crt = false;
  CrtOptions options;
  std::vector<CLI::Option*> of_crt;
  CLI::Option* scale = nullptr;
};

std::optional<CrtOptions> chosen(Asked& asked) {
  if (!asked.crt) {
    for (const CLI::Option* option : asked.of_crt)
      if (option->count() > 0)
        throw CLI::ValidationError(option->get_name(), "belongs to --monitor crt");
    return std::nullopt;
  }
  CrtOptions& options = asked.options;
  if (options.scan_lines > 0) {
    if (asked.scale->count() == 0) options.scale = CrtOptions::kLeastScanLineScale;
    if (options.scale < CrtOptions::kLeastScanLineScale)
      throw CLI::ValidationError(
          "--scanlines", fmt::format("needs --scale {} or more", CrtOptions::kLeastScanLineScale));
  }
  return options;
}

std::string at(const eltek::Chromaticity& xy) { return fmt::format("{:.4g} {:.4g}", xy.x, xy.y); }

std::string effects_text(const CrtOptions& options) {
  std::string text;
  if (options.scale > 1) text += fmt::format("; {0}x{0} pixels for one", options.scale);
  if (options.aspect) text += "; pixels 65:64";
  if (options.spot > 0) text += fmt::format("; spot of sigma {} pixels", options.spot);
  if (options.scan_lines > 0)
    text += fmt::format("; scan lines {}, mean light x{}", options.scan_lines,
                        1 - options.scan_lines / 2);
  return text.empty() ? text : "\n  " + text.substr(2);
}

}  // namespace

std::function<std::optional<CrtOptions>()> add_monitor(CLI::App* app) {
  const auto asked = std::make_shared<Asked>();
  CrtOptions& options = asked->options;
  add_choice(app, "--monitor", asked->crt, {{"ideal", false}, {"crt", true}},
             "codes as sRGB bytes, or through a model of a colour tube (ideal)");
  asked->scale = app->add_option("--scale", options.scale, "each pixel as N x N; whole, 1 to 8 (1)")
                     ->check(CLI::Range(1, CrtOptions::kMaxScale))
                     ->type_name("N");
  asked->of_crt = {
      add_choice(app, "--phosphors", options.tube.phosphors,
                 {{"smpte-c", PhosphorSet::smpte_c},
                  {"p22-h273", PhosphorSet::p22_h273},
                  {"p22-dosbox", PhosphorSet::p22_dosbox}},
                 "the tube's primaries (smpte-c)"),
      add_choice(app, "--white", options.tube.white,
                 {{"d65", WhitePoint::d65}, {"9300k", WhitePoint::k9300}},
                 "the tube's white; 9300k is shown bluish (d65)"),
      add_number(app, "--gamma", options.tube.gamma, 1, 4,
                 "light is voltage to this power; 2.5 is a tube's by itself (2.2)"),
      asked->scale,
      app->add_flag("--aspect", options.aspect, "pixels 65:64 wide, as on a tube of 4:3"),
      add_number(app, "--spot", options.spot, CrtOptions::kLeastSpot, CrtOptions::kMaxSpot,
                 "blur by the beam's spot, a Gaussian of this sigma in pixels (none)"),
      add_number(app, "--scanlines", options.scan_lines, 0, 1,
                 "darker between lines by this much; --scale is then 3 or more (0)")};
  for (CLI::Option* option : asked->of_crt) option->group("With --monitor crt");
  return [asked] { return chosen(*asked); };
}

std::string monitor_text(const eltek::Crt& crt) {
  const eltek::TubeOptions& tube = crt.tube().options();
  const eltek::Phosphors& set = phosphors(tube.phosphors);
  const std::array<eltek::Voltages, 4> most{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}};
  std::array<std::string, 4> shown;
  const std::vector<quant::Light> light = crt.tube().light_of(most);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Rgb8 byte = quant::LinearLight::table().colour(light[i]);
    shown[i] = fmt::format("{},{},{}", byte.r, byte.g, byte.b);
  }
  return fmt::format(
             "monitor crt (our model: the thesis gives codes from 0 to 63 and no more)\n"
             "  light = {:.4g} (code / largest code)^{}\n"
             "  white {} at {}, as sRGB {}\n"
             "  phosphors {}: red at {}, as sRGB {}; green at {}, {}; blue at {}, {}",
             crt.tube().gain(), tube.gamma, white(tube.white).name, at(white(tube.white).at),
             shown[3], set.name, at(set.primary[0]), shown[0], at(set.primary[1]), shown[1],
             at(set.primary[2]), shown[2]) +
         effects_text(crt.options());
}

}  // namespace sir::cli
