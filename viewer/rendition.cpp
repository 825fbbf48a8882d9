#include "viewer/rendition.h"

#include <chrono>
#include <stdexcept>
#include <utility>

#include "quant/best.h"
#include "quant/choose.h"
#include "quant/shown_through.h"
#include "tracer/scene_path.h"

namespace sir::viewer {
namespace {

/// Does the work and tells its time.
template <typename Work>
double milliseconds(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

// What `sir lut` chooses by default.
quant::Lut thesis_lut(const Planes& image, quant::Method method, quant::Space space) {
  quant::ChooseOptions options;
  options.method = method;
  options.space = space;
  return quant::choose_lut(image, options);
}

// What `sir lut --method best` chooses by default, with the same --reserve as `sir show`.
quant::Lut best_lut(const Planes& image, const quant::IndexSet& reserved, std::stop_token stop) {
  quant::WeightedColours colours;
  colours.add(image);
  quant::BestOptions options;
  options.reserved = reserved;
  options.entries = (~reserved).count();
  return quant::choose_best(colours, options, {}, std::move(stop)).lut;
}

quant::Lut chosen_lut(const Planes& image, Method method, const quant::IndexSet& reserved,
                      std::stop_token stop) {
  using quant::Space;
  switch (method) {
    case Method::rgb_frequency: return thesis_lut(image, quant::Method::frequency, Space::rgb);
    case Method::rgb_median: return thesis_lut(image, quant::Method::median, Space::rgb);
    case Method::hsv_frequency: return thesis_lut(image, quant::Method::frequency, Space::hsv);
    case Method::hsv_median: return thesis_lut(image, quant::Method::median, Space::hsv);
    case Method::best: return best_lut(image, reserved, std::move(stop));
    case Method::true_colour:
    case Method::lut_file: break;
  }
  throw std::invalid_argument("a LUT is not chosen for " + std::string(name(method)));
}

}  // namespace

std::optional<std::filesystem::path> lut_file(const std::filesystem::path& base,
                                              const RenditionOptions& options) {
  return options.lut ? options.lut : existing_by_suffix(base, "LUT");
}

Rendition make_rendition(const Picture& picture, Method method, const RenditionOptions& options,
                         std::stop_token stop) {
  Rendition made;
  made.method = method;
  made.reserved = options.map.reserved;
  made.choose_ms = milliseconds([&] {
    if (method == Method::lut_file) {
      const auto path = options.lut ? *options.lut : find_by_suffix(picture.base, "LUT");
      made.lut = quant::read_lut(path);
      made.lut_name = path.filename().string();
    } else {
      made.lut = chosen_lut(picture.planes, method, made.reserved, std::move(stop));
      made.lut_name = "chosen by " + std::string(name(method));
    }
  });
  made.map_ms =
      milliseconds([&] { made.indices = quant::map_image(picture.planes, made.lut, options.map); });
  made.seen = quant::as_seen(picture.planes.size, made.indices, made.lut);
  return made;
}

}  // namespace sir::viewer
