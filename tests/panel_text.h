// Finds what the panel has written in a window's pixels, so that tests click what a person would.
#pragma once

#include <optional>
#include <string_view>

#include "eltek/screen.h"
#include "viewer/viewport.h"

namespace sir::test {

inline constexpr Rgb8 kPanelInk{255, 255, 255};    ///< texts and labels
inline constexpr Rgb8 kPanelFaint{128, 128, 128};  ///< what is still to come
inline constexpr Rgb8 kPanelAlarm{255, 115, 89};

/// The middle of the first such text, row by row from `from_row` on; none where it is not. ASCII in
/// Dear ImGui's own letters, pixel for pixel.
std::optional<viewer::Place> find_text(const eltek::Screen& screen, std::string_view text,
                                       Rgb8 ink = kPanelInk, int from_row = 0);

/// The same where nothing is written beside it: a label of its own, as "<" beside "<<".
std::optional<viewer::Place> find_label(const eltek::Screen& screen, std::string_view text,
                                        int from_row = 0);

}  // namespace sir::test
