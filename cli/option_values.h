// Values of options that are more than a number.
#pragma once

#include <string>
#include <string_view>

#include "tracer/render.h"
#include "viewer/image_name.h"

namespace sir::cli {

/// "WxH", both positive, at most kMostPixels in all. The parsers return false,
/// and leave the value alone, where the text is nothing of the kind.
bool parse_size(std::string_view text, ImageSize& size);

/// "X,Y,W,H" with X, Y >= 0 and W, H > 0.
bool parse_region(std::string_view text, Region& region);

/// Bytes a second: a positive number, with k or M for thousands or millions; at most 1e15.
bool parse_rate(std::string_view text, double& rate);

/// "none", "adaptive[:THRESHOLD[:LEVELS]]" or "random[:SAMPLES[:SEED]]"; what is left
/// out has its default.
bool parse_antialias(std::string_view text, AntialiasOptions& options);

/// "auto", "all", or the names of effects separated by commas.
bool parse_effects(std::string_view text, EffectSet& effects);

/// The names of the effects, for a help text.
std::string known_effects();

/// The precision as it is given on the command line.
const char* name_of(Precision precision);

/// BASE as it was meant.
using viewer::given_base;

}  // namespace sir::cli
