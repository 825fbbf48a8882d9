// The program that shows an image on the monitor (thesis 3.5).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "eltek/ma120.h"
#include "eltek/screen.h"
#include "quant/lut.h"

namespace sir::eltek {

/// An image after the search in the LUT (step b): one index a pixel, rows
/// from the top. `name` stands for the image in errors.
struct IndexedImage {
  std::string name;
  ImageSize size;
  std::span<const std::uint8_t> indices;
};

/// What to do with an image that is larger than the screen.
enum class Oversize { refuse, crop };

/// Where an image goes: the area of the screen, and the column and row of the
/// image that lands in that area's upper left corner.
struct Placement {
  Area on_screen;
  int image_column = 0;
  int image_row = 0;
};

/// Centres an image: column floor((1024-w)/2), row floor((780-h)/2). Of a
/// larger image the centred part is taken, or it is refused (FileError).
/// An image without pixels is refused.
Placement place(const std::string& name, ImageSize image, Oversize oversize);

/// Step a: initialises the monitor's LUT through its ports, from entry 0 on.
void load_lut(LutPorts& ports, const quant::Lut& lut);

/// The entry whose colour as seen is nearest to black by squared distance,
/// the lowest on ties; it fills the screen around an image.
std::uint8_t nearest_to_black(const quant::Lut& lut);

/// Steps a to c: loads the LUT, opens both masks, sends the image's indices
/// to its centred place and the index nearest to black to the rest of the
/// screen. Returns the image's area on the screen. Throws FileError for an
/// image that does not fit (see place), std::invalid_argument where indices
/// and size disagree.
Area show_image(Ma120& monitor, const IndexedImage& image, const quant::Lut& lut,
                Oversize oversize = Oversize::refuse);

}  // namespace sir::eltek
