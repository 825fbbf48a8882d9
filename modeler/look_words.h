// The words behind camera, light, surface, view and the like: English and Portuguese.
#pragma once

#include <cstdint>
#include <span>

#include "modeler/commands.h"
#include "modeler/looks.h"

namespace sir::modeler {

enum class CameraWord : std::uint8_t {
  window,
  target,
  normal,
  distance,
  up,
  focal,
  parallel,
  perspective,
  load,
  save,
  frame,
  turn,
  pan,
  zoom,
  made_up
};
std::span<const Word<CameraWord>> camera_words();

enum class LightWord : std::uint8_t {
  background,
  ambient,
  add,
  move,
  colour,
  erase,
  set,
  load,
  save,
  made_up
};
std::span<const Word<LightWord>> light_words();

enum class SurfacesWord : std::uint8_t { load, save, erase };
std::span<const Word<SurfacesWord>> surfaces_words();

enum class SurfaceWord : std::uint8_t {
  name,
  colour,
  ambient,
  diffuse,
  specular,
  exponent,
  transmission,
  index,
  plain,
  chequer,
  odd,
  even
};
std::span<const Word<SurfaceWord>> surface_words();

/// The switches of ViewSettings.
std::span<const Word<bool ViewSettings::*>> view_words();
std::span<const Word<bool>> switch_words();  ///< on, off

enum class ScriptWord : std::uint8_t { load, save };
std::span<const Word<ScriptWord>> script_words();

}  // namespace sir::modeler
