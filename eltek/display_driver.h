// The program that shows an image on the monitor (thesis 3.5).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "eltek/bus.h"
#include "eltek/ma120.h"
#include "eltek/screen.h"
#include "quant/index_set.h"
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

/// Step a: initialises the monitor's LUT through its registers, from entry 0 on.
/// Throws std::invalid_argument for a LUT of another DAC than the one fitted:
/// its codes would be seen as other colours.
void load_lut(Bus& bus, const quant::Lut& lut);

/// The entry whose colour as seen is nearest to black by squared distance,
/// the lowest on ties, out of those that are not reserved; it fills the screen
/// around an image. Throws std::invalid_argument where all are.
std::uint8_t nearest_to_black(const quant::Lut& lut, const quant::IndexSet& reserved = {});

/// Steps a to c, by registers alone: loads the LUT, opens both masks, ends blanking, sends row
/// after row the image's indices to its centred place and the index nearest to black, which is
/// no reserved one, to the rest of the screen. Returns the image's area on the screen. Throws
/// FileError for an image that does not fit (see place), std::invalid_argument where indices and
/// size disagree, where the LUT is not for the monitor's DAC and where all entries are reserved;
/// the screen then stays as it was.
Area show_image(Bus& bus, const IndexedImage& image, const quant::Lut& lut,
                Oversize oversize = Oversize::refuse, const quant::IndexSet& reserved = {});

/// The same through a bus of its own, to which nobody listens.
Area show_image(Ma120& monitor, const IndexedImage& image, const quant::Lut& lut,
                Oversize oversize = Oversize::refuse, const quant::IndexSet& reserved = {});

}  // namespace sir::eltek
