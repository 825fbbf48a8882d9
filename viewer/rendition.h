// An image made ready for the monitor by one method: its LUT and its pixels' indices
// (thesis 3.4, 3.5 a-c).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "quant/lut.h"
#include "quant/map_image.h"
#include "viewer/method.h"
#include "viewer/picture.h"

namespace sir::viewer {

/// What `sir show` was told about all its images.
struct RenditionOptions {
  quant::MapOptions map;                     ///< how pixels become indices
  std::optional<std::filesystem::path> lut;  ///< Method::lut_file's; none: BASE.LUT or BASE.lut
};

/// Never changed once made, so that threads may share it.
struct Rendition {
  Method method = Method::hsv_median;
  std::string lut_name;  ///< for titles: the file's name, or "chosen by median in hsv"
  quant::Lut lut;
  std::vector<std::uint8_t> indices;  ///< one a pixel, rows from the top
  quant::IndexSet reserved;           ///< as in RenditionOptions::map
  Planes seen;                        ///< each pixel as its entry is seen
  double choose_ms = 0;               ///< choosing the LUT, or reading its file
  double map_ms = 0;                  ///< finding the indices
};

/// The file that Method::lut_file would read: the one that was told, else BASE.LUT or BASE.lut
/// where it exists, else none.
std::optional<std::filesystem::path> lut_file(const std::filesystem::path& base,
                                              const RenditionOptions& options);

/// Chooses or reads the LUT and maps the picture. Throws FileError for a LUT that cannot be read
/// or is not there, std::invalid_argument for Method::true_colour. A stop request ends the choice
/// of Method::best early, with a LUT that is less good.
Rendition make_rendition(const Picture& picture, Method method, const RenditionOptions& options,
                         std::stop_token stop = {});

}  // namespace sir::viewer
