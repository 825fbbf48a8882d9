// An image as it was opened, before any LUT: what the monitor's picture is measured against.
#pragma once

#include <filesystem>
#include <memory>

#include "tracer/planes.h"
#include "tracer/scene.h"

namespace sir::viewer {

/// A finished read or a stage of a render; never changed afterwards, so that threads may share it.
struct Picture {
  std::filesystem::path input;         ///< BASE or FILE.png, as it was opened
  std::filesystem::path base;          ///< FILE.png without its suffix; names LUT and screenshots
  Planes planes;                       ///< the true colours
  std::shared_ptr<const Scene> scene;  ///< behind BASE; none for PNG files and bare planes
  double share = 1;                    ///< of the pixels, those traced so far; 1: the whole image
};

}  // namespace sir::viewer
