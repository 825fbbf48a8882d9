// The LUT duel: which of two LUTs shows each pixel of a picture better (thesis 4, where the
// methods are compared by eye).
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "tracer/planes.h"

namespace sir::viewer {

/// Two CIEDE2000 of a pixel that differ by less are equal to the eye: a CIEDE2000 of 1 is just
/// visible under good conditions (quant/ciede2000.h), a difference of half as much between two
/// errors is not.
inline constexpr double kEqualToTheEye = 0.5;

enum class Winner : std::uint8_t { tie, a, b };

struct Duel {
  ImageSize size{0, 0};
  std::vector<Winner> winner;  ///< of each pixel, rows from the top
  std::uint64_t won_by_a = 0, won_by_b = 0, ties = 0;
  double mean_a = 0, mean_b = 0;  ///< CIEDE2000 over all pixels
};

/// Compares two pictures as shown with the true one. A stop request ends it early with an empty
/// duel. Throws std::invalid_argument for pictures of different sizes or without pixels.
Duel duel(const Planes& reference, const Planes& a, const Planes& b, std::stop_token stop = {});

/// Where A wins and where B: blue and orange, which people of all kinds of colour vision tell
/// apart (Okabe and Ito 2008).
inline constexpr Rgb8 kColourOfA{0, 114, 178}, kColourOfB{230, 159, 0};

/// The duel as a picture: the reference in dimmed grey, under the winner's colour where there is
/// one. Throws std::invalid_argument where the reference is of another size than the duel.
Planes duel_map(const Planes& reference, const Duel& duel);

/// For people, by the names of the two.
std::vector<std::string> describe(const Duel& duel, const std::string& a, const std::string& b);

}  // namespace sir::viewer
