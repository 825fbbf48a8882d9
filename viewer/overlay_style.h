// The parts that the viewer's overlay is put together from. The thesis has none of them.
#pragma once

#include <string>
#include <vector>

#include "viewer/canvas.h"
#include "viewer/prompt.h"
#include "viewer/viewport.h"

namespace sir::viewer {

class Viewer;

inline constexpr Argb kInk = 0xFFF2F2F2;     ///< text
inline constexpr Argb kFaint = 0xFFA8B0B8;   ///< text of less weight
inline constexpr Argb kAccent = 0xFFFFC857;  ///< what is chosen, headings
inline constexpr Argb kShade = 0xFF101418;   ///< beside ink, so that it shows on white
inline constexpr Argb kPanel = 0xE6101418;   ///< behind text
inline constexpr Argb kChosen = 0xFF2F4A66;  ///< behind what is chosen
inline constexpr int kMargin = 4;            ///< around text, in pixels

/// What a block of lines takes, margins included. Lines that begin with a letter are headings,
/// those that begin with blanks belong to them.
int block_width(const std::vector<std::string>& lines, int scale);
int block_height(std::size_t lines, int scale);
void draw_block(Canvas& canvas, Place corner, const std::vector<std::string>& lines, int scale);

/// The height of the strip with the viewer's message; 0 where there is none.
int strip_height(const Viewer& viewer, int scale);

/// All commands with their keys, group by group, in the middle of the canvas.
void draw_key_sheet(Canvas& canvas, int scale);

/// The prompt at the top, and under it what may be chosen.
void draw_prompt(Canvas& canvas, const Prompt& prompt, int scale);

}  // namespace sir::viewer
