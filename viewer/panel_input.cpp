#include "viewer/panel_input.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <utility>

#include "viewer/sdl_video.h"

namespace sir::viewer {
namespace {

constexpr std::array kKeys{
    std::pair{ImGuiKey_Tab, SDL_SCANCODE_TAB},
    std::pair{ImGuiKey_LeftArrow, SDL_SCANCODE_LEFT},
    std::pair{ImGuiKey_RightArrow, SDL_SCANCODE_RIGHT},
    std::pair{ImGuiKey_UpArrow, SDL_SCANCODE_UP},
    std::pair{ImGuiKey_DownArrow, SDL_SCANCODE_DOWN},
    std::pair{ImGuiKey_PageUp, SDL_SCANCODE_PAGEUP},
    std::pair{ImGuiKey_PageDown, SDL_SCANCODE_PAGEDOWN},
    std::pair{ImGuiKey_Home, SDL_SCANCODE_HOME},
    std::pair{ImGuiKey_End, SDL_SCANCODE_END},
    std::pair{ImGuiKey_Delete, SDL_SCANCODE_DELETE},
    std::pair{ImGuiKey_Backspace, SDL_SCANCODE_BACKSPACE},
    std::pair{ImGuiKey_Enter, SDL_SCANCODE_RETURN},
    std::pair{ImGuiKey_KeyPadEnter, SDL_SCANCODE_KP_ENTER},
    std::pair{ImGuiKey_Escape, SDL_SCANCODE_ESCAPE},
    // With Ctrl, in fields: all, copy, paste, cut, redo, undo.
    std::pair{ImGuiKey_A, SDL_SCANCODE_A},
    std::pair{ImGuiKey_C, SDL_SCANCODE_C},
    std::pair{ImGuiKey_V, SDL_SCANCODE_V},
    std::pair{ImGuiKey_X, SDL_SCANCODE_X},
    std::pair{ImGuiKey_Y, SDL_SCANCODE_Y},
    std::pair{ImGuiKey_Z, SDL_SCANCODE_Z},
};

std::size_t button_of(std::uint8_t button) {
  return button == SDL_BUTTON_LEFT ? 0u : button == SDL_BUTTON_RIGHT ? 1u : 2u;
}

// A letter is the key that writes it, which is elsewhere on some keyboards.
std::size_t key_of(const SDL_Keysym& key) {
  const bool letter = key.sym >= SDLK_a && key.sym <= SDLK_z;
  return static_cast<std::size_t>(letter ? SDL_SCANCODE_A + (key.sym - SDLK_a) : key.scancode);
}

const ImVec2 kNowhere{-std::numeric_limits<float>::max(), -std::numeric_limits<float>::max()};

}  // namespace

PanelInput::PanelInput() {
  ImGuiIO& io = ImGui::GetIO();
  io.BackendPlatformName = "sir";
  for (const auto& [key, scancode] : kKeys) io.KeyMap[key] = scancode;
  io.ClipboardUserData = &clipboard_;
  io.GetClipboardTextFn = [](void* kept) {
    char* text = SDL_GetClipboardText();
    auto& clipboard = *static_cast<std::string*>(kept);
    clipboard = text != nullptr ? text : "";
    SDL_free(text);
    return clipboard.c_str();
  };
  io.SetClipboardTextFn = [](void*, const char* text) { SDL_SetClipboardText(text); };
}

void PanelInput::pass(const SDL_Event& event) {
  ImGuiIO& io = ImGui::GetIO();
  const auto place = [](int x, int y) {
    return ImVec2(static_cast<float>(x), static_cast<float>(y));
  };
  switch (event.type) {
    case SDL_MOUSEMOTION: io.MousePos = place(event.motion.x, event.motion.y); break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      io.MousePos = place(event.button.x, event.button.y);
      if (event.button.button <= SDL_BUTTON_RIGHT) {
        const std::size_t button = button_of(event.button.button);
        held_[button] = event.type == SDL_MOUSEBUTTONDOWN;
        pressed_[button] |= held_[button];
      }
      break;
    case SDL_MOUSEWHEEL: io.MouseWheel += static_cast<float>(event.wheel.y); break;
    case SDL_TEXTINPUT: io.AddInputCharactersUTF8(event.text.text); break;
    case SDL_KEYDOWN:
    case SDL_KEYUP: {
      const auto key = key_of(event.key.keysym);
      if (key < std::size(io.KeysDown)) {
        std::erase(rising_, key);
        if (event.type == SDL_KEYDOWN) io.KeysDown[key] = true;
        else rising_.push_back(key);
      }
      io.KeyShift = (event.key.keysym.mod & KMOD_SHIFT) != 0;
      io.KeyCtrl = (event.key.keysym.mod & KMOD_CTRL) != 0;
      io.KeyAlt = (event.key.keysym.mod & KMOD_ALT) != 0;
      break;
    }
    case SDL_WINDOWEVENT:
      if (event.window.event == SDL_WINDOWEVENT_LEAVE && !any_button_held()) io.MousePos = kNowhere;
      if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) release_keys();
      break;
    default: break;
  }
}

void PanelInput::reset() {
  held_ = pressed_ = {};
  ImGui::GetIO().MousePos = kNowhere;
  release_keys();
}

void PanelInput::release_keys() {
  ImGuiIO& io = ImGui::GetIO();
  std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
  io.KeyShift = io.KeyCtrl = io.KeyAlt = false;
  rising_.clear();
}

void PanelInput::end_frame() {
  for (const std::size_t key : rising_) ImGui::GetIO().KeysDown[key] = false;
  rising_.clear();
}

void PanelInput::begin_frame(SDL_Window* window, SDL_Renderer* renderer) {
  ImGuiIO& io = ImGui::GetIO();
  int width = 0, height = 0;
  SDL_GetWindowSize(window, &width, &height);
  const PixelSize pixels = pixel_size(renderer);
  io.DisplaySize = ImVec2(static_cast<float>(width), static_cast<float>(height));
  io.DisplayFramebufferScale =
      ImVec2(static_cast<float>(pixels.width) / static_cast<float>(std::max(width, 1)),
             static_cast<float>(pixels.height) / static_cast<float>(std::max(height, 1)));
  for (std::size_t i = 0; i < held_.size(); ++i) io.MouseDown[i] = held_[i] || pressed_[i];
  pressed_ = {};
}

}  // namespace sir::viewer
