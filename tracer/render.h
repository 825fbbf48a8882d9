// SIR (thesis 3.3): sends a primary ray through every pixel and collects the
// planes.
#pragma once

#include "tracer/antialias.h"
#include "tracer/model.h"
#include "tracer/ray_counts.h"
#include "tracer/tile_keeper.h"
#include "tracer/tiles.h"
#include "tracer/trace_log.h"
#include "tracer/trace_options.h"

namespace sir {

/// The scalar type of all tracing. long_double is the compiler's: 80 bits, 64 of
/// them digits, on x86; where it is the same as double, so are the images. The
/// files' numbers are doubles, so what coincides in them does by double's measure
/// (Numeric::kGrain).
enum class Precision : std::uint8_t { float_, double_, long_double };

struct RenderOptions {
  ImageSize size;
  Region region;    ///< an empty one stands for the whole image
  int threads = 0;  ///< 0: as many as cores
  Precision precision = Precision::double_;
  TraceOptions trace;
  AntialiasOptions antialias;
  TileKeeper* keeper = nullptr;  ///< given the tiles as they are finished, and asked for them first

  /// Whether more than one ray a pixel is both wanted and allowed.
  bool antialiased() const {
    return antialias.mode != Antialias::none && trace.allowed_effects.antialias;
  }
};

/// The region, or the whole image where it is empty. Throws
/// std::invalid_argument for one that does not lie within the image.
Region region_or_all(const Region& region, ImageSize size);

struct RenderResult {
  Planes planes;     ///< of the region
  RayCounts counts;  ///< with those of tiles that a keeper gave
  AntialiasCounts antialias;
  double prepare_seconds = 0;  ///< matrices, envelopes, hierarchy
  double trace_seconds = 0;
  double processor_seconds = 0;  ///< of tracing, all threads together
  EffectSet effects;             ///< those that ran
  bool complete = true;          ///< false: stopped before the end
};

/// Renders; the planes are the same for any number of threads. `progress`, if
/// given, is called now and then from any thread, one call at a time, with the
/// share of the pixels done, in [0,1]. A stop request ends it within 256
/// pixels of each thread. Throws std::invalid_argument for a region outside the image and for
/// options of antialiasing out of their ranges.
RenderResult render(const Scene& scene, const RenderOptions& options,
                    const std::function<void(double)>& progress = {}, std::stop_token stop = {});

/// The same for a scene that has been made ready, as for many frames of which only
/// the camera differs: one ray through each pixel's centre. Of the options the
/// precision, the formulas, the effects and antialiasing are not looked at; the
/// model was made for them. `prepare_seconds` is 0.
template <typename T>
RenderResult render_model(const Model<T>& model, const RenderOptions& options,
                          const std::function<void(double)>& progress = {},
                          std::stop_token stop = {});

/// The tree behind the pixel in column i and row j, and its bytes.
struct PixelTrace {
  TraceLog log;
  Rgb8 pixel;
};
PixelTrace trace_pixel(const Scene& scene, const RenderOptions& options, int i, int j);

}  // namespace sir
