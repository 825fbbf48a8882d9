#include "viewer/sdl_keys.h"

namespace sir::viewer {
namespace {

char32_t named(SDL_Keycode code) {
  switch (code) {
    case SDLK_ESCAPE: return kEscape;
    case SDLK_RETURN:
    case SDLK_KP_ENTER: return kEnter;
    case SDLK_TAB: return kTab;
    case SDLK_BACKSPACE: return kBackspace;
    case SDLK_LEFT: return kLeft;
    case SDLK_RIGHT: return kRight;
    case SDLK_UP: return kUp;
    case SDLK_DOWN: return kDown;
    case SDLK_PAGEUP: return kPageUp;
    case SDLK_PAGEDOWN: return kPageDown;
    case SDLK_HOME: return kHome;
    case SDLK_END: return kEnd;
    case SDLK_F1: return kF1;
    case SDLK_F5: return kF5;
    case SDLK_F11: return kF11;
    case SDLK_KP_PLUS: return U'+';
    case SDLK_KP_MINUS: return U'-';
    default: return 0;
  }
}

// The digit of a key, -1 for none.
int digit_of(const SDL_Keysym& key) {
  if (key.sym >= SDLK_0 && key.sym <= SDLK_9) return key.sym - SDLK_0;
  if (key.sym == SDLK_KP_0 || key.scancode == SDL_SCANCODE_0) return 0;
  if (key.sym >= SDLK_KP_1 && key.sym <= SDLK_KP_9) return key.sym - SDLK_KP_1 + 1;
  if (key.scancode >= SDL_SCANCODE_1 && key.scancode <= SDL_SCANCODE_9)
    return key.scancode - SDL_SCANCODE_1 + 1;
  return -1;
}

}  // namespace

Key key_of(const SDL_Keysym& key) {
  Key result;
  result.ctrl = (key.mod & KMOD_CTRL) != 0;
  result.alt = (key.mod & KMOD_LALT) != 0;
  result.shift = (key.mod & KMOD_SHIFT) != 0;
  result.code = named(key.sym);
  if (result.code != 0) return result;
  if (const int digit = digit_of(key); digit >= 0) {
    result.code = U'0' + static_cast<char32_t>(digit);
    result.shift = false;
  } else if (key.sym >= ' ' && key.sym <= '~') {
    result.code = static_cast<char32_t>(key.sym);
  }
  return result;
}

std::optional<Button> button_of(std::uint8_t button) {
  switch (button) {
    case SDL_BUTTON_LEFT: return Button::left;
    case SDL_BUTTON_MIDDLE: return Button::middle;
    case SDL_BUTTON_RIGHT: return Button::right;
    default: return std::nullopt;
  }
}

}  // namespace sir::viewer
