// Lets libpng's errors, which are longjmps, end as ordinary return values.
#pragma once

#include <png.h>

#include <csetjmp>
#include <cstdio>

namespace sir::viewer {

/// The latest reason that libpng gave; a plain array, because nothing may be
/// allocated on the way to a longjmp.
struct PngReason {
  char text[160] = "unknown reason";
};

[[noreturn]] inline void on_png_error(png_structp png, png_const_charp reason) {
  auto* kept = static_cast<PngReason*>(png_get_error_ptr(png));
  std::snprintf(kept->text, sizeof kept->text, "%s", reason);
  png_longjmp(png, 1);
}

inline void on_png_warning(png_structp, png_const_charp) {}

/// Calls step(), which calls libpng; false if libpng gave up within it.
/// A longjmp runs no destructors: neither step nor what it calls may own
/// anything. What it works on belongs to the caller, outside.
template <class Step>
bool png_succeeds(png_structp png, const Step& step) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  step();
  return true;
}

}  // namespace sir::viewer
