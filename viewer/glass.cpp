#include "viewer/glass.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "viewer/overlay.h"

namespace sir::viewer {
namespace {

// Canvas leaves colours over nothing multiplied by their alpha; SDL's blending multiplies itself.
Argb divided_by_alpha(Argb word) {
  const std::uint32_t alpha = word >> 24;
  if (alpha == 0 || alpha == 255) return word;
  Argb divided = alpha << 24;
  for (const int shift : {16, 8, 0})
    divided |= std::min((word >> shift & 0xFF) * 255 / alpha, 255u) << shift;
  return divided;
}

// Neighbours are mostly alike.
void divide_by_alpha(std::span<Argb> words) {
  Argb last = 0, divided = 0;
  for (Argb& word : words) {
    if (word != last) divided = divided_by_alpha(last = word);
    word = divided;
  }
}

}  // namespace

void Glass::draw(Viewer& viewer, int scale) {
  draw_picture(viewer);
  if (has_overlay(viewer)) draw_text(viewer, scale);
}

void Glass::forget() {
  picture_.reset();
  text_.reset();
}

bool Glass::fit(Owned<SDL_Texture>& texture, ImageSize size, SDL_BlendMode blend) {
  ImageSize now{0, 0};
  if (texture) SDL_QueryTexture(texture.get(), nullptr, nullptr, &now.width, &now.height);
  if (texture && now == size) return false;
  texture.reset(SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_STREAMING,
                                  size.width, size.height));
  check(texture != nullptr, "cannot hold the screen");
  // The hint for nearest scaling loses to a variable of the environment.
  SDL_SetTextureScaleMode(texture.get(), SDL_ScaleModeNearest);
  SDL_SetTextureBlendMode(texture.get(), blend);
  return true;
}

void Glass::draw_picture(Viewer& viewer) {
  const Frame& frame = viewer.picture();
  const bool empty = fit(picture_, frame.size, SDL_BLENDMODE_NONE);
  if (empty || viewer.picture_version() != picture_version_)
    check(SDL_UpdateTexture(picture_.get(), nullptr, frame.words.data(), 4 * frame.size.width) == 0,
          "cannot hold the screen");
  picture_version_ = viewer.picture_version();
  // Only what can be seen: at large multiples the whole would exceed what renderers can place.
  const Letterbox seen = viewer.viewport().visible(), box = viewer.viewport().box();
  const int m = viewer.viewport().multiple();
  const SDL_Rect from{seen.x, seen.y, seen.width, seen.height};
  const SDL_Rect to{box.x + seen.x * m, box.y + seen.y * m, seen.width * m, seen.height * m};
  if (seen.width > 0 && seen.height > 0)
    check(SDL_RenderCopy(renderer_, picture_.get(), &from, &to) == 0, "cannot be drawn to");
}

void Glass::draw_text(Viewer& viewer, int scale) {
  const ImageSize size = viewer.viewport().window();
  if (size.width < 1 || size.height < 1) return;
  const auto pitch = static_cast<std::size_t>(size.width);
  const auto rows = [&](const Rectangle& area, const auto& work) {
    for (int y = area.y; y < area.y + area.height; ++y)
      work(std::span(words_).subspan(
          static_cast<std::size_t>(y) * pitch + static_cast<std::size_t>(area.x),
          static_cast<std::size_t>(area.width)));
  };
  if (fit(text_, size, SDL_BLENDMODE_BLEND)) words_.assign(size.pixels(), 0);
  else rows(painted_, [](std::span<Argb> row) { std::fill(row.begin(), row.end(), 0); });
  Canvas canvas(words_, size);
  draw_overlay(canvas, viewer, scale);
  painted_ = canvas.painted();
  if (painted_.width == 0) return;
  rows(painted_, divide_by_alpha);
  const SDL_Rect where{painted_.x, painted_.y, painted_.width, painted_.height};
  const Argb* first =
      &words_[static_cast<std::size_t>(painted_.y) * pitch + static_cast<std::size_t>(painted_.x)];
  check(SDL_UpdateTexture(text_.get(), &where, first, 4 * size.width) == 0 &&
            SDL_RenderCopy(renderer_, text_.get(), &where, &where) == 0,
        "cannot be drawn to");
}

}  // namespace sir::viewer
