// Where a scene is fragile: the pixels whose list of boundaries hangs on the
// precision or on a rounding (for RAY-TRACING, thesis 2.3.6).
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "tracer/render.h"

namespace sir {

/// Why a pixel hesitates; both may be.
enum Hesitation : std::uint8_t {
  kPrecision = 1,  ///< float and double find other boundaries
  kRounding = 2    ///< boundaries change where every end of a primitive moves by 1 to 31 ulp of
                   ///< t, each primitive by its own number, outwards or inwards, and none are
                   ///< fused: faces that coincide, or nearly
};

/// Of the region of an image.
struct HesitationMap {
  struct Count {
    std::uint64_t precision = 0, rounding = 0;  ///< pixels
  };
  ImageSize size;
  std::vector<std::uint8_t> causes;     ///< of each pixel, rows from the top; 0: sure
  std::map<std::int64_t, Count> nodes;  ///< by the primitives' node numbers: those whose
                                        ///< boundaries come, go or change places
  Count pixels;
  bool complete = true;  ///< false: stopped before the end
};

/// Compares the boundaries (node, face, side, in order) on the primary ray of
/// each pixel. Takes `size`, `region` and `threads` of the options; the same for
/// any number of threads. Throws std::invalid_argument for a region outside
/// the image.
HesitationMap find_hesitation(const Scene& scene, const RenderOptions& options,
                              const std::function<void(double)>& progress = {},
                              std::stop_token stop = {});

/// The image with its hesitating pixels marked: the others as dark greys,
/// precision red, rounding blue, both yellow. `image` is of the map's size.
Planes marked(const Planes& image, const HesitationMap& map);

}  // namespace sir
