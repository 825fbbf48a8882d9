// Reading and writing the four files of a scene (BASICO, thesis 3.6).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "tracer/scene.h"
#include "tracer/text_file.h"

namespace sir {

/// Reads BASE.CSG, BASE.CAM, BASE.LUZ and BASE.SUP and checks that they fit
/// together. Throws FileError, located, at the first thing that is wrong; a
/// missing file is named with the places where it was looked for.
Scene read_scene(const std::filesystem::path& base);

/// The single files. Each reads to the end and refuses anything left over, and more nodes,
/// surfaces or lights than limits() takes.
CsgTree read_csg(TextFile& file);
CameraFile read_camera(TextFile& file);
Lighting read_lighting(TextFile& file);
std::vector<Surface> read_surfaces(TextFile& file);

/// Refuses more of `things`, "nodes", than limits().nodes, before there is memory for any.
void require_at_most(const TextFile& file, std::int64_t announced, const char* things);

/// Refuses a primitive whose surface number is not described; `csg_name` is the
/// file named in the error, `surfaces_name` the one where it should be.
void check_surfaces(const CsgTree& tree, const std::vector<Surface>& surfaces,
                    const std::string& csg_name, const std::string& surfaces_name);

/// The files' text, in the layout of docs/scene-format.md; numbers are written so that they
/// read back to the same bits.
std::string csg_text(const CsgTree& tree);
std::string camera_text(const CameraFile& camera);
std::string lighting_text(const Lighting& lighting);
std::string surfaces_text(const std::vector<Surface>& surfaces);

/// Writes all four beside `base`, together (see atomic_files.h). Throws FileError.
void write_scene(const std::filesystem::path& base, const Scene& scene);

}  // namespace sir
