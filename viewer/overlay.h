// What the viewer writes over the picture: values, the inspector, the sheet of keys. The thesis's
// monitor showed the picture alone.
#pragma once

#include "viewer/canvas.h"
#include "viewer/viewer.h"

namespace sir::viewer {

/// From this multiple on pixels are large enough for the three values of their colour.
inline constexpr int kValuesFrom = 32;

/// Whether draw_overlay() would paint anything.
bool has_overlay(const Viewer& viewer);

/// Paints it into a canvas of the viewer's window, which is transparent (0) before. Letters are
/// `scale` times as large, for dense displays. The canvas's words are then premultiplied by their
/// alpha, as Canvas leaves translucent colours over nothing.
void draw_overlay(Canvas& canvas, Viewer& viewer, int scale);

}  // namespace sir::viewer
