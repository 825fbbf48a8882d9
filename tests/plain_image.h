// What every way to an image is compared with.
#pragma once

#include <cstddef>

#include "tracer/render.h"
#include "tracer/trace.h"

namespace sir::test {

/// The plain path: every primitive, table 2.4, a whole tree of rays for each pixel, of which none
/// is spared, one after the other.
template <typename T>
Planes plain_image(const Model<T>& model, const RenderOptions& options) {
  TraceOptions plain = options.trace;
  plain.engine = Engine::roth;
  Tracer<T> tracer(model, plain);
  Planes planes(options.size);
  std::size_t p = 0;
  for (int j = 0; j < options.size.height; ++j)
    for (int i = 0; i < options.size.width; ++i, ++p)
      planes.set(p, to_rgb8(tracer.radiance(model.camera.primary_ray(i, j, options.size))));
  return planes;
}

}  // namespace sir::test
