// From SDL's keys to the viewer's (viewer/key.h). Present only in builds with SIR_WITH_SDL.
#pragma once

#include <SDL.h>

#include "viewer/key.h"
#include "viewer/viewer.h"

namespace sir::viewer {

/// The key; its code is 0 where the viewer has no name for it. Digits count by what they type or
/// else by where they lie: on some keyboards the row of digits types them only with Shift.
Key key_of(const SDL_Keysym& key);

/// A mouse button; none for those beyond the third.
std::optional<Button> button_of(std::uint8_t button);

}  // namespace sir::viewer
