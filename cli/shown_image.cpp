#include "cli/shown_image.h"

#include <string>

#include "cli/output_path.h"
#include "eltek/display_driver.h"
#include "quant/dac_parse.h"
#include "tracer/atomic_file.h"
#include "tracer/scene_path.h"
#include "viewer/image_name.h"

namespace sir::cli {

ShownImage prepare(const std::filesystem::path& input, const ShowOptions& options,
                   const Session& session) {
  ShownImage image;
  viewer::Picture& picture = image.picture;
  picture.input = input;
  picture.base = viewer::base_name(input);
  picture.planes = viewer::load_image(input, options.size);
  // An image that does not fit is refused before a LUT is sought for it.
  eltek::place(input.string(), picture.planes.size,
               options.crop ? eltek::Oversize::crop : eltek::Oversize::refuse);
  const viewer::RenditionOptions how{options.map, options.lut};
  const auto path = viewer::lut_file(picture.base, how);
  for (const auto& output : {options.png, options.trace})
    if (path && output) refuse_same_file(*output, *path);
  image.rendition = viewer::make_rendition(
      picture, path ? viewer::Method::lut_file : viewer::Method::hsv_median, how);
  if (path) detail(session, input.string() + ": shown with " + path->string());
  else
    note(session, input.string() + ": there is no " + with_suffix(picture.base, "LUT").string() +
                      "; shown with a LUT " + image.rendition.lut_name);
  if (const quant::DacBits& dac = image.rendition.lut.dac; dac != quant::DacBits{})
    note(session, input.string() + ": shown through a DAC of " + quant::bits_text(dac) +
                      " bits, which the MA120 did not have");
  return image;
}

}  // namespace sir::cli
