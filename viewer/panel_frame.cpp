#include "viewer/panel_frame.h"

#include <backends/imgui_impl_sdlrenderer.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

namespace sir::viewer {

PanelFrame::Context::Context() { ImGui::CreateContext(); }

PanelFrame::Context::~Context() { ImGui::DestroyContext(); }

PanelFrame::PanelFrame(SDL_Window* window, SDL_Renderer* renderer, int width)
    : window_(window), renderer_(renderer), width_(width) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // leaves no files behind
  // Nothing moves by itself: the same events give the same picture.
  io.ConfigInputTextCursorBlink = false;
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowBorderSize = 0;
  style.AntiAliasedLines = style.AntiAliasedFill = false;  // SDL's software renderer has none
  ImGui_ImplSDLRenderer_Init(renderer);
}

PanelFrame::~PanelFrame() { ImGui_ImplSDLRenderer_Shutdown(); }

bool PanelFrame::takes(const SDL_Event& event) {
  input_.pass(event);
  const ImGuiIO& io = ImGui::GetIO();
  switch (event.type) {
    case SDL_MOUSEMOTION: return holder_.value_or(owner_at(event.motion.x)) == Owner::panel;
    case SDL_MOUSEBUTTONDOWN:
      if (!holder_) holder_ = owner_at(event.button.x);
      return holder_ == Owner::panel;
    case SDL_MOUSEBUTTONUP: {
      const bool mine = holder_ == Owner::panel;
      if (!input_.any_button_held()) holder_.reset();
      return mine;
    }
    case SDL_MOUSEWHEEL: return owner_at(static_cast<int>(io.MousePos.x)) == Owner::panel;
    case SDL_TEXTINPUT: return io.WantTextInput;
    case SDL_KEYDOWN:
      return io.WantTextInput || (event.key.keysym.sym == SDLK_ESCAPE && list_open());
    default: return false;
  }
}

void PanelFrame::reset() {
  input_.reset();
  holder_.reset();
}

void PanelFrame::forget() { ImGui_ImplSDLRenderer_DestroyDeviceObjects(); }

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
  close_list();
  ImGui::Render();
  input_.end_frame();
  // The backend leaves the density of the pixels to the renderer's scale.
  SDL_RenderSetScale(renderer_, io.DisplayFramebufferScale.x, io.DisplayFramebufferScale.y);
  ImGui_ImplSDLRenderer_RenderDrawData(ImGui::GetDrawData());
  SDL_RenderSetScale(renderer_, 1, 1);
}

// Esc closes menus, lists and choosers; a dialog sees to itself.
void PanelFrame::close_list() {
  if (!ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) return;
  const auto& open = ImGui::GetCurrentContext()->OpenPopupStack;
  if (open.empty() || open.back().Window == nullptr) return;
  if ((open.back().Window->Flags & ImGuiWindowFlags_Modal) != 0) return;
  ImGui::ClosePopupToLevel(open.Size - 1, true);
}

bool PanelFrame::list_open() const { return ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup); }

// An open list is closed by a click beside it, which does nothing else.
PanelFrame::Owner PanelFrame::owner_at(int x) const {
  int width = 0;
  SDL_GetWindowSize(window_, &width, nullptr);
  return list_open() || x >= width - width_ ? Owner::panel : Owner::picture;
}

}  // namespace sir::viewer
