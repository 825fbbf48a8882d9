// PNG files in and out: the only user of libpng. The thesis has no PNG; its
// files of an image are those of section 3.6.4.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "eltek/screen.h"
#include "tracer/atomic_file.h"
#include "tracer/planes.h"

namespace sir::viewer {

/// Writes three planes as an RGB PNG of 8 bits a sample. The file says
/// nothing about time or gamma, so equal planes give equal files.
/// Throws FileError where the file cannot be written or the image is empty.
void write_rgb_png(const std::filesystem::path& path, const Planes& planes);

/// Writes a screen as an indexed PNG: all 256 entries in LUT order, equal ones
/// included, as the bytes that are seen; sBIT says how many bits of each count:
/// the DAC's, 6 on the MA120.
/// Throws as above.
void write_indexed_png(const std::filesystem::path& path, const eltek::IndexedScreen& screen);

/// The same two into a file whose commit() is the caller's.
void write_rgb_png(AtomicFile& output, const Planes& planes);
void write_indexed_png(AtomicFile& output, const eltek::IndexedScreen& screen);

/// Reads a PNG of any kind into planes. Sample values are taken as stored:
/// gAMA, iCCP and sRGB are ignored. Palette entries and greys become RGB;
/// 16 bits become 8, rounded; 1, 2 and 4 bits of grey are spread over 0..255.
/// Throws FileError, with the reason in one line, for a file that is missing,
/// empty, no PNG, damaged, cut off or of more pixels than limits() takes, and for
/// one with a pixel that is not fully opaque. Memory goes with the pixels that the
/// file has, not with those that it announces; chunks beside them are skipped.
Planes read_png(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in errors.
Planes parse_png(const std::string& name, std::span<const std::uint8_t> bytes);

}  // namespace sir::viewer
