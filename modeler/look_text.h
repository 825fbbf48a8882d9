// Looks, view and selection as the commands that make them: a line each, which gives the same to
// the last bit.
#pragma once

#include <string>
#include <vector>

#include "modeler/looks.h"

namespace sir::modeler {

/// "camera window 4 3 target 0 0 0 ... perspective"; "camera auto" where there is none.
std::string camera_line(const CameraFile& camera);
std::string camera_line(const std::optional<CameraFile>& camera);

/// "light set background ... ambient ... add ... add ..."; "light auto" where there is none.
std::string light_line(const Lighting& lighting);
std::string light_line(const std::optional<Lighting>& lighting);

/// "surface 3 name ... ambient ..."
std::string surface_line(const Surface& surface);

/// "view ghosts on", a line for each that is not as in `besides`.
std::vector<std::string> view_lines(const ViewSettings& view, const ViewSettings& besides = {});

/// "select NAME PLACE FACE", no longer than it must be; "select" alone for none.
std::string select_line(const std::optional<Selection>& selection);

}  // namespace sir::modeler
