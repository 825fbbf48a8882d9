#include "cli/paint_command.h"

#include <numeric>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/image_input.h"
#include "cli/output_path.h"
#include "viewer/png_file.h"

namespace sir::cli {
namespace {

std::string as_text(const std::filesystem::path& output, const quant::Painted& painted,
                    std::uint64_t all) {
  const auto pixels = static_cast<double>(painted.image.size.pixels());
  std::string text =
      fmt::format("{}: {} of {} pixels painted ({:.2f} %)\n", output.string(), all,
                  painted.image.size.pixels(), 100 * static_cast<double>(all) / pixels);
  if (painted.picked.size() > 1)
    for (std::size_t rule = 0; rule < painted.picked.size(); ++rule)
      text += fmt::format("  rule {}: {}\n", rule + 1, painted.picked[rule]);
  return text;
}

}  // namespace

int run_paint(const PaintOptions& options, const Session& session) {
  const Planes image = load_image(options.input, options.size);
  refuse_input_file(options.output, options.input);
  const quant::Painted painted = quant::paint(image, options.rules, options.rest);
  require_picture_name(options.output);
  viewer::write_rgb_png(options.output, painted.image);
  const auto all = std::accumulate(painted.picked.begin(), painted.picked.end(), std::uint64_t{0});
  print(options.json ? nlohmann::ordered_json{{"pixels", image.size.pixels()},
                                              {"painted", all},
                                              {"rules", painted.picked}}
                               .dump() +
                           "\n"
                     : as_text(options.output, painted, all));
  detail(session, options.output.string() + " written");
  return kDone;
}

}  // namespace sir::cli
