#include "cli/cost/lut_work.h"

#include "quant/colour_points.h"
#include "quant/map_image.h"
#include "quant/nearest.h"

namespace sir::cli {
namespace {

ChosenLut by_method(const quant::ChooseOptions& options, const Planes& image) {
  const auto cells = quant::count_for(image, options);
  ChosenLut chosen{quant::choose_from(cells, options), cells.size(), 0};
  chosen.entries = chosen.lut.chosen;
  return chosen;
}

ChosenLut by_best(const quant::BestOptions& options, const Planes& image) {
  quant::WeightedColours colours;
  colours.add(image);
  const auto best = quant::choose_best(colours, options);
  return {best.lut, colours.all().size(), best.entries};
}

}  // namespace

ChosenLut chosen_by(const LutChoice& choice, const Planes& image) {
  if (const auto* options = std::get_if<quant::BestOptions>(&choice))
    return by_best(*options, image);
  return by_method(std::get<quant::ChooseOptions>(choice), image);
}

std::vector<std::uint8_t> mapped_by(const LutMapping& mapping, const Planes& image,
                                    const quant::Lut& lut) {
  switch (mapping.search) {
    case Search::approximate: return quant::map_to_lut(image, lut, quant::Mapping::approximate);
    case Search::exhaustive: return quant::map_exhaustively(image, lut);
    case Search::exact:
      return quant::map_image(image, lut, {quant::Goal::psnr, {}, mapping.dither});
    default: return quant::map_image(image, lut, {quant::Goal::perceptual, {}, mapping.dither});
  }
}

}  // namespace sir::cli
