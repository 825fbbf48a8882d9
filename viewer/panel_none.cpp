// Builds without Dear ImGui: the viewer has no panel.
#include "viewer/panel.h"

namespace sir::viewer {

std::unique_ptr<Panel> make_panel(SDL_Window*, SDL_Renderer*, Viewer&) { return nullptr; }

}  // namespace sir::viewer
