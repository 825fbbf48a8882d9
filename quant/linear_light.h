// Light in proportion to its energy, from stored bytes and back.
#pragma once

#include <array>
#include <cstdint>

#include "tracer/planes.h"

namespace sir::quant {

/// A colour by its primaries in linear light, 0 to 1 each. What the eye mixes at a distance is
/// the mean of these, not of the bytes.
using Light = std::array<double, 3>;

/// The curve of sRGB (IEC 61966-2-1) from a coded primary, 0 to 1, to its light.
double light_of_coded(double coded);

/// The light of a byte, by a table of light_of_coded(byte / 255).
double light_of(std::uint8_t byte);
inline Light light_of(Rgb8 colour) {
  return {light_of(colour.r), light_of(colour.g), light_of(colour.b)};
}

/// The way back: the byte whose coded value is nearest, the larger one half-way between two.
/// That is the largest byte k with light_of_coded((k - 1/2) / 255) <= light; 0 below all of
/// them (the curve grows, so each byte has one range of light). By a table and one comparison.
std::uint8_t byte_of_light(double light);
inline Rgb8 colour_of_light(const Light& light) {
  return {byte_of_light(light[0]), byte_of_light(light[1]), byte_of_light(light[2])};
}

}  // namespace sir::quant
