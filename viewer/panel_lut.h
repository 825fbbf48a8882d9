// The panel's LUT: 16x16 fields in LUT order, what each entry is and how often it is used
// (thesis 3.4: 256 entries of 0..63 a primary). Only in builds with Dear ImGui.
#pragma once

#include <optional>

#include "viewer/lut_usage.h"
#include "viewer/viewer.h"

namespace sir::viewer {

/// Hovering a field shows the pixels that use the entry, a click keeps them shown. Another order
/// is a matter of this view: neither the LUT nor the picture changes. What is not counted yet is
/// left out.
class LutPart {
 public:
  void draw(Viewer& viewer);

 private:
  void draw_order();
  void draw_fields(Viewer& viewer, const Rendition& rendition, const LutUsage* usage);

  EntryOrder order_ = EntryOrder::index;
};

}  // namespace sir::viewer
