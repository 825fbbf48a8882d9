// Flat areas: what dither must leave alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tracer/planes.h"

namespace sir::quant {

/// A flat area has so many pixels at least. Smaller ones are shades of a texture, or so small
/// that nobody sees noise in them.
inline constexpr std::size_t kFlatPixels = 32;

/// One flag a pixel, set where the image is flat: dither would put noise there, on grounds,
/// discs and letters that were drawn in one colour.
///
/// An area is a set of pixels of exactly one colour that hang together by their sides. It is flat
/// if it has kFlatPixels and is no step of a slope. For a slow slope, in bytes, is a stair of areas
/// of one colour, often many pixels wide, and those are just where false contours show
/// unless they are dithered. The border of an area tells: it consists of pairs of pixels side by
/// side, one within and one outside. A pair leads down or up a slope if from its inner pixel on,
/// straight outwards, five pixels in a row differ by no more than 4 levels in each primary from one
/// to the next (those outside of the image are taken to go on the same): the DAC's own step, as
/// in quant/banding.h. An area is a step of a slope if a third of its border's pairs are such.
/// - A strip of a gradient has both of its long sides on the slope; the last strip before an
///   edge one of them, less the ends: hence a third, not a half.
/// - Noise of less than a step, as JPEG leaves it in a sky, counts as slope.
/// - Smoothed edges, also with ringing as good filters and JPEG leave it beside them, are no
///   slope: the first pixels outside may be within a step, the edge itself follows soon.
/// - An area without a border, the whole image, is flat.
std::vector<std::uint8_t> flat_areas(const Planes& image);

}  // namespace sir::quant
