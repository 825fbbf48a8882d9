// Rendering with more than one ray a pixel (thesis 2.4.5).
#pragma once

#include "tracer/render.h"
#include "tracer/sample_points.h"

namespace sir {

/// render() by options.antialias, which is not `none`; same arguments, same errors. A
/// stop request ends it within 256 points of each thread; the planes of what was not finished are
/// black.
RenderResult render_antialiased(const Scene& scene, const RenderOptions& options,
                                const std::function<void(double)>& progress = {},
                                std::stop_token stop = {});

/// The same with a sampler made for the options: fills in result.planes and
/// result.antialias; false where it was stopped.
bool antialias(const RenderOptions& options, PointSampler& sampler,
               const std::function<void(double)>& progress, const std::stop_token& stop,
               RenderResult& result);

}  // namespace sir
