// All fuzz targets, each in a file of its name; docs/fuzzing.md tells what each one promises.
#pragma once

#include <array>
#include <string_view>

#include "fuzz/target.h"

namespace sir::fuzz {

void play_camera(Bytes bytes);
void play_csg(Bytes bytes);
void play_light(Bytes bytes);
void play_lut(Bytes bytes);
void play_pipeline(Bytes bytes);
void play_pipeline_text(Bytes bytes);
void play_png(Bytes bytes);
void play_probe(Bytes bytes);
void play_script(Bytes bytes);
void play_surfaces(Bytes bytes);
void play_trace(Bytes bytes);

/// A target by the name that its program, seeds and corpus have.
struct Target {
  std::string_view name;
  Play play;
};

inline constexpr std::array kTargets{
    Target{"camera", play_camera},     Target{"csg", play_csg},
    Target{"light", play_light},       Target{"lut", play_lut},
    Target{"pipeline", play_pipeline}, Target{"pipeline_text", play_pipeline_text},
    Target{"png", play_png},           Target{"probe", play_probe},
    Target{"script", play_script},     Target{"surfaces", play_surfaces},
    Target{"trace", play_trace},
};

}  // namespace sir::fuzz
