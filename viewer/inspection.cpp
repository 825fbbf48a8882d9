#include "viewer/inspection.h"

#include <stdexcept>
#include <utility>

#include "quant/nearest.h"
#include "quant/perceptual_search.h"

namespace sir::viewer {
namespace {

/// The pixel's place on the monitor, an image that is too large being cut to its centre.
std::optional<eltek::Area> on_screen(const Picture& picture, int column, int row) {
  const auto placed =
      eltek::place(picture.input.string(), picture.planes.size, eltek::Oversize::crop);
  const int x = column - placed.image_column, y = row - placed.image_row;
  const eltek::Area& area = placed.on_screen;
  if (x < 0 || y < 0 || x >= area.size.width || y >= area.size.height) return std::nullopt;
  return eltek::Area{area.column + x, area.row + y, {1, 1}};
}

/// Entries that are seen as the same colour as this one.
quant::IndexSet alike(const quant::Lut& lut, std::uint8_t index) {
  quant::IndexSet set;
  for (std::size_t i = 0; i < quant::kLutEntries; ++i) set[i] = lut.seen(i) == lut.seen(index);
  return set;
}

}  // namespace

std::optional<quant::ChooseOptions> choice_of(Method method) {
  quant::ChooseOptions options;
  const bool rgb = method == Method::rgb_frequency || method == Method::rgb_median;
  options.space = rgb ? quant::Space::rgb : quant::Space::hsv;
  switch (method) {
    case Method::rgb_frequency:
    case Method::hsv_frequency: options.method = quant::Method::frequency; return options;
    case Method::rgb_median:
    case Method::hsv_median: options.method = quant::Method::median; return options;
    default: return std::nullopt;
  }
}

Inspector::Inspector(std::shared_ptr<const Picture> picture,
                     std::shared_ptr<const Rendition> rendition, const quant::MapOptions& map)
    : picture_(std::move(picture)), rendition_(std::move(rendition)), map_(map) {
  if (picture_->scene) ray_.emplace(picture_->scene, picture_->planes.size);
  if (!rendition_) return;
  groups_ = quant::entry_groups(picture_->planes, rendition_->indices);
  if (const auto choice = choice_of(rendition_->method)) {
    provenance_.emplace(picture_->planes, *choice);
    // A LUT that was made with other options, or for an earlier stage of the picture, has another
    // story than this one.
    if (!(provenance_->lut() == rendition_->lut)) provenance_.reset();
  }
}

Inspection Inspector::inspect(int column, int row) {
  const ImageSize size = picture_->planes.size;
  if (column < 0 || row < 0 || column >= size.width || row >= size.height)
    throw std::out_of_range("a pixel that does not lie within the picture");
  const auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(size.width) +
                     static_cast<std::size_t>(column);
  const std::scoped_lock lock(in_use_);
  Inspection found;
  found.column = column;
  found.row = row;
  found.screen = on_screen(*picture_, column, row);
  found.true_colour = picture_->planes.at(pixel);
  found.complete = picture_->share >= 1;
  if (rendition_) found.shown = shown(pixel);
  if (ray_) found.ray = ray_->find(column, row);
  return found;
}

PixelShown Inspector::shown(std::size_t pixel) {
  const Rgb8 colour = picture_->planes.at(pixel);
  const quant::Lut& lut = rendition_->lut;
  const std::uint8_t index = rendition_->indices[pixel];
  PixelShown found;
  found.method = rendition_->method;
  found.lut_name = rendition_->lut_name;
  found.entry = distance(colour, index);
  found.code = lut.entry[index];
  found.dac = lut.dac;
  found.by_bytes = nearest(colour, quant::Goal::psnr);
  if (map_.by == quant::Goal::perceptual) found.by_eye = nearest(colour, map_.by);
  const NearestTwo& as_mapped = found.by_eye ? *found.by_eye : found.by_bytes;
  found.dithered = index != as_mapped.winner.index;
  found.group = groups_[index];
  found.image_pixels = rendition_->indices.size();
  if (const auto other = quant::nearest_other(lut, index))
    found.nearest_other = distance(lut.seen(index), *other);
  if (provenance_) {
    found.choice = provenance_->options();
    found.origin = provenance_->of(colour);
    if (const auto made = found.origin->entry)
      found.made = distance(colour, static_cast<std::uint8_t>(*made));
  }
  return found;
}

EntryDistance Inspector::distance(Rgb8 colour, std::uint8_t index) {
  const Rgb8 seen = rendition_->lut.seen(index);
  return {index, seen, quant::squared_distance(colour, seen), difference_(colour, seen)};
}

NearestTwo Inspector::nearest(Rgb8 colour, quant::Goal by) {
  const quant::Lut& lut = rendition_->lut;
  const auto among = [&](const quant::IndexSet& left_out) {
    const std::uint8_t index = by == quant::Goal::psnr
                                   ? quant::nearest_entry(colour, lut, left_out)
                                   : quant::perceptually_nearest(colour, lut, measure_, left_out);
    return distance(colour, index);
  };
  NearestTwo two{among(rendition_->reserved), std::nullopt};
  const auto others = rendition_->reserved | alike(lut, two.winner.index);
  if (!others.all()) two.runner_up = among(others);
  return two;
}

}  // namespace sir::viewer
