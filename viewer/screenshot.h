// Where screenshots go, and frames as images. The thesis took its pictures with a camera.
#pragma once

#include <filesystem>
#include <string>

#include "tracer/planes.h"
#include "viewer/frame.h"

namespace sir::viewer {

/// FOLDER/STEM.png, or STEM-2.png, STEM-3.png ...: the first that does not exist.
std::filesystem::path free_name(const std::filesystem::path& folder, const std::string& stem);

/// The frame's colours split into three planes.
Planes to_planes(const Frame& frame);

}  // namespace sir::viewer
