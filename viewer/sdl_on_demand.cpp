// SDL2 is loaded when the first of its functions is called, not when the program starts: it
// brings some forty libraries along, and all but one of our commands open no window. Each
// function that our files and Dear ImGui's call is defined here by its own name and passes the call
// on.
#include <SDL.h>
#include <dlfcn.h>

#include <cstdarg>
#include <string>

#include "tracer/error.h"

namespace {

void* library() {
  static void* const loaded = ::dlopen("libSDL2-2.0.so.0", RTLD_NOW | RTLD_LOCAL);
  if (loaded == nullptr)
    throw sir::FileError("window", 0,
                         std::string("SDL2 cannot be loaded (") + ::dlerror() +
                             "); use --terminal or --png OUT.png");
  return loaded;
}

template <typename Function>
Function* find(const char* name) {
  void* const found = ::dlsym(library(), name);
  if (found == nullptr) throw sir::FileError("window", 0, std::string("SDL2 has no ") + name);
  return reinterpret_cast<Function*>(found);
}

}  // namespace

#define PASS_ON(result, name, parameters, arguments)           \
  extern "C" result SDLCALL name parameters {                  \
    static auto* const function = find<decltype(name)>(#name); \
    return function arguments;                                 \
  }

PASS_ON(SDL_Renderer*, SDL_CreateRenderer, (SDL_Window * window, int index, Uint32 flags),
        (window, index, flags))
PASS_ON(SDL_Texture*, SDL_CreateTexture,
        (SDL_Renderer * renderer, Uint32 format, int access, int w, int h),
        (renderer, format, access, w, h))
PASS_ON(SDL_Window*, SDL_CreateWindow,
        (const char* title, int x, int y, int w, int h, Uint32 flags), (title, x, y, w, h, flags))
PASS_ON(void, SDL_DestroyRenderer, (SDL_Renderer * renderer), (renderer))
PASS_ON(void, SDL_DestroyTexture, (SDL_Texture * texture), (texture))
PASS_ON(void, SDL_DestroyWindow, (SDL_Window * window), (window))
PASS_ON(char*, SDL_GetClipboardText, (), ())
PASS_ON(const char*, SDL_GetCurrentVideoDriver, (), ())
PASS_ON(int, SDL_GetDisplayUsableBounds, (int displayIndex, SDL_Rect* rect), (displayIndex, rect))
PASS_ON(const char*, SDL_GetError, (), ())
PASS_ON(const char*, SDL_GetHint, (const char* name), (name))
PASS_ON(int, SDL_GetRendererInfo, (SDL_Renderer * renderer, SDL_RendererInfo* info),
        (renderer, info))
PASS_ON(int, SDL_GetRendererOutputSize, (SDL_Renderer * renderer, int* w, int* h), (renderer, w, h))
PASS_ON(int, SDL_GetWindowDisplayIndex, (SDL_Window * window), (window))
PASS_ON(Uint32, SDL_GetWindowFlags, (SDL_Window * window), (window))
PASS_ON(void, SDL_GetWindowPosition, (SDL_Window * window, int* x, int* y), (window, x, y))
PASS_ON(void, SDL_GetWindowSize, (SDL_Window * window, int* w, int* h), (window, w, h))
PASS_ON(const char*, SDL_GetWindowTitle, (SDL_Window * window), (window))
PASS_ON(int, SDL_InitSubSystem, (Uint32 flags), (flags))
PASS_ON(int, SDL_PollEvent, (SDL_Event * event), (event))
PASS_ON(int, SDL_PushEvent, (SDL_Event * event), (event))
PASS_ON(int, SDL_QueryTexture, (SDL_Texture * texture, Uint32* format, int* access, int* w, int* h),
        (texture, format, access, w, h))
PASS_ON(void, SDL_QuitSubSystem, (Uint32 flags), (flags))
PASS_ON(int, SDL_RenderClear, (SDL_Renderer * renderer), (renderer))
PASS_ON(int, SDL_RenderCopy,
        (SDL_Renderer * renderer, SDL_Texture* texture, const SDL_Rect* srcrect,
         const SDL_Rect* dstrect),
        (renderer, texture, srcrect, dstrect))
PASS_ON(void, SDL_RenderPresent, (SDL_Renderer * renderer), (renderer))
PASS_ON(int, SDL_RenderReadPixels,
        (SDL_Renderer * renderer, const SDL_Rect* rect, Uint32 format, void* pixels, int pitch),
        (renderer, rect, format, pixels, pitch))
PASS_ON(int, SDL_SetClipboardText, (const char* text), (text))
PASS_ON(SDL_bool, SDL_SetHint, (const char* name, const char* value), (name, value))
PASS_ON(void, SDL_SetMainReady, (), ())
PASS_ON(int, SDL_SetRenderDrawColor, (SDL_Renderer * renderer, Uint8 r, Uint8 g, Uint8 b, Uint8 a),
        (renderer, r, g, b, a))
PASS_ON(int, SDL_SetTextureBlendMode, (SDL_Texture * texture, SDL_BlendMode blendMode),
        (texture, blendMode))
PASS_ON(int, SDL_SetTextureScaleMode, (SDL_Texture * texture, SDL_ScaleMode scaleMode),
        (texture, scaleMode))
PASS_ON(void, SDL_SetWindowPosition, (SDL_Window * window, int x, int y), (window, x, y))
PASS_ON(void, SDL_SetWindowSize, (SDL_Window * window, int w, int h), (window, w, h))
PASS_ON(void, SDL_SetWindowTitle, (SDL_Window * window, const char* title), (window, title))
PASS_ON(int, SDL_UpdateTexture,
        (SDL_Texture * texture, const SDL_Rect* rect, const void* pixels, int pitch),
        (texture, rect, pixels, pitch))
PASS_ON(int, SDL_WaitEvent, (SDL_Event * event), (event))
PASS_ON(void, SDL_free, (void* memory), (memory))
PASS_ON(int, SDL_SetWindowFullscreen, (SDL_Window * window, Uint32 flags), (window, flags))
PASS_ON(int, SDL_RenderSetScale, (SDL_Renderer * renderer, float x, float y), (renderer, x, y))
PASS_ON(void, SDL_RenderGetScale, (SDL_Renderer * renderer, float* x, float* y), (renderer, x, y))
PASS_ON(void, SDL_RenderGetClipRect, (SDL_Renderer * renderer, SDL_Rect* rect), (renderer, rect))
PASS_ON(int, SDL_RenderSetClipRect, (SDL_Renderer * renderer, const SDL_Rect* rect),
        (renderer, rect))
PASS_ON(void, SDL_RenderGetViewport, (SDL_Renderer * renderer, SDL_Rect* rect), (renderer, rect))
PASS_ON(int, SDL_RenderSetViewport, (SDL_Renderer * renderer, const SDL_Rect* rect),
        (renderer, rect))
PASS_ON(SDL_bool, SDL_RenderIsClipEnabled, (SDL_Renderer * renderer), (renderer))
PASS_ON(int, SDL_RenderGeometryRaw,
        (SDL_Renderer * renderer, SDL_Texture* texture, const float* xy, int xy_stride,
         const SDL_Color* color, int color_stride, const float* uv, int uv_stride, int num_vertices,
         const void* indices, int num_indices, int size_indices),
        (renderer, texture, xy, xy_stride, color, color_stride, uv, uv_stride, num_vertices,
         indices, num_indices, size_indices))
PASS_ON(void, SDL_LogMessageV,
        (int category, SDL_LogPriority priority, const char* form, va_list values),
        (category, priority, form, values))

// The one function with any number of arguments.
extern "C" void SDLCALL SDL_Log(const char* form, ...) {
  va_list values;
  va_start(values, form);
  SDL_LogMessageV(SDL_LOG_CATEGORY_APPLICATION, SDL_LOG_PRIORITY_INFO, form, values);
  va_end(values);
}
