#include "viewer/panel_frame.h"

#include <backends/imgui_impl_sdlrenderer.h>
#include <imgui.h>

#include <algorithm>

namespace sir::viewer {

PanelFrame::Context::Context() { ImGui::CreateContext(); }

PanelFrame::Context::~Context() { ImGui::DestroyContext(); }

PanelFrame::PanelFrame(SDL_Window* window, SDL_Renderer* renderer, int width)
    : window_(window), renderer_(renderer), width_(width) {
  ImGui::GetIO().IniFilename = nullptr;  // leaves no files behind
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowBorderSize = 0;
  style.AntiAliasedLines = style.AntiAliasedFill = false;  // SDL's software renderer has none
  ImGui_ImplSDLRenderer_Init(renderer);
}

PanelFrame::~PanelFrame() { ImGui_ImplSDLRenderer_Shutdown(); }

bool PanelFrame::takes(const SDL_Event& event) {
  input_.pass(event);
  const ImGuiIO& io = ImGui::GetIO();
  const bool popup = has_popup();
  switch (event.type) {
    case SDL_MOUSEMOTION: return held_;
    case SDL_MOUSEBUTTONDOWN: return held_ = popup || is_within(event.button.x);
    case SDL_MOUSEBUTTONUP: {
      const bool was_held = held_;
      held_ = false;
      return was_held;
    }
    case SDL_MOUSEWHEEL: return popup || is_within(static_cast<int>(io.MousePos.x));
    case SDL_TEXTINPUT:
    case SDL_KEYDOWN: return io.WantTextInput;
    default: return false;
  }
}

bool PanelFrame::has_popup() {
  return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

void PanelFrame::draw(const std::function<void()>& parts) {
  input_.begin_frame(window_, renderer_);
  // Two clicks are one double click only where they are near in time.
  const auto now = Clock::now();
  const float seconds = std::chrono::duration<float>(now - drawn_).count();
  ImGui::GetIO().DeltaTime = std::clamp(seconds, 0.001f, 1.0f);
  drawn_ = now;
  ImGui_ImplSDLRenderer_NewFrame();
  ImGui::NewFrame();
  const ImGuiIO& io = ImGui::GetIO();
  const auto width = static_cast<float>(width_);
  ImGui::SetNextWindowPos({io.DisplaySize.x - width, 0});
  ImGui::SetNextWindowSize({width, io.DisplaySize.y});
  ImGui::Begin("panel", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoNav);
  parts();
  ImGui::End();
  ImGui::Render();
  input_.end_frame();
  // The backend leaves the density of the pixels to the renderer's scale.
  SDL_RenderSetScale(renderer_, io.DisplayFramebufferScale.x, io.DisplayFramebufferScale.y);
  ImGui_ImplSDLRenderer_RenderDrawData(ImGui::GetDrawData());
  SDL_RenderSetScale(renderer_, 1, 1);
}

bool PanelFrame::is_within(int x) const {
  int width = 0;
  SDL_GetWindowSize(window_, &width, nullptr);
  return x >= width - width_;
}

}  // namespace sir::viewer
