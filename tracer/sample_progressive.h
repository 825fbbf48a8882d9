// Coarse to fine (Bronsvoort, van Wijk, Jansen 1984; thesis 2.5.1): a whole image after
// 1/256 of the rays, refined where it changes.
#pragma once

#include "tracer/render.h"

namespace sir {

/// What a picture shown on the way is made of.
struct Stage {
  int block = 1;              ///< side of its squares of one colour, in pixels
  bool refined_only = false;  ///< true: pixels that nothing called for are guessed
  bool antialiased = false;   ///< the last picture, where antialiasing is asked for
  double share = 0;           ///< of the image's pixels, those traced so far
};

/// Receives a picture of the whole region, in the calling thread.
using ShowStage = std::function<void(const Planes& picture, const Stage& stage)>;

/// render() by way of coarse pictures, with the same image in the end. The pixels whose
/// column and row in the region are multiples of 16 come first, each as the colour of its
/// square of 16x16 pixels. Squares that differ in any byte from one of the eight around
/// them are then divided into four, down to single pixels: pictures of blocks of 8, 4, 2
/// and 1. Then all that was never traced is. Where antialiasing is asked for, the
/// antialiased image, made anew, is the last picture.
///
/// `show` is called after each stage; its time does not count. A stop request takes effect
/// within 256 pixels of each thread; the planes are then the latest picture, and `complete`
/// is false.
RenderResult render_progressive(const Scene& scene, const RenderOptions& options,
                                const ShowStage& show, std::stop_token stop = {},
                                const std::function<void(double)>& progress = {});

/// A quick picture of blocks of `block` (16, 8, 4, 2 or 1) pixels, for aiming a camera or
/// choosing a surface: small things may be missing. With `refine` the stage of that block
/// of render_progressive(); without it, every block is traced. Never antialiased. Throws
/// std::invalid_argument for another `block`.
RenderResult render_preview(const Scene& scene, const RenderOptions& options, int block,
                            bool refine, std::stop_token stop = {});

}  // namespace sir
