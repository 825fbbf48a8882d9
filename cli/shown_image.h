// An image made ready for the MA120 as `sir show` was told (thesis 3.5 a, b).
#pragma once

#include <filesystem>

#include "cli/session.h"
#include "cli/show_command.h"
#include "viewer/picture.h"
#include "viewer/rendition.h"

namespace sir::cli {

/// Read and mapped at once, for outputs that wait for it.
struct ShownImage {
  viewer::Picture picture;
  viewer::Rendition rendition;
};

/// Reads the image and its LUT, or chooses one by median in hsv, which a note tells, as another
/// tells of a DAC that is not the MA120's. Throws FileError, also for an image that does not fit
/// and where an output would go to the LUT's file.
ShownImage prepare(const std::filesystem::path& input, const ShowOptions& options,
                   const Session& session);

}  // namespace sir::cli
