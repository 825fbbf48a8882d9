// Everything of the viewer that takes time: reading, rendering, choosing LUTs. The window asks
// and never waits; the user of the thesis's laboratory (3.5) waits at each step.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "viewer/latest.h"
#include "viewer/rendition.h"

namespace sir::viewer {

struct WorkshopOptions {
  ImageSize size;  ///< of planes and of renders
  RenditionOptions rendition;
  int threads = 0;  ///< in all; 0: as many as cores. One is left to the window.
  std::chrono::milliseconds watch_every{250};
  /// Something is new. Called by any thread, at any time, but not after the workshop is gone; must
  /// return soon and not call the workshop.
  std::function<void()> wake = [] {};
};

/// Opened images, read or rendered in the background, read again whenever their files change, and
/// made ready for the monitor by each method as asked. All members are for one thread, the
/// window's, and none of them waits; only the destructor does, for what cannot be cut short: the
/// file that is being read, the pixels that are being traced, the step of a LUT that is being
/// chosen.
///
/// An image is taken anew when its files have changed and have then been at rest for `watch_every`
/// (see FileWatch), so that planes of two images are not mixed. As long as the new one cannot be
/// read, the last good picture stays.
class Workshop {
 public:
  explicit Workshop(WorkshopOptions options);
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  /// Adds an image: FILE.png, BASE, or one of the files of BASE. Returns its number, which counts
  /// from 0; the same input may be opened again.
  std::size_t open(const std::filesystem::path& input);
  std::size_t count() const;

  struct State {
    /// The latest good one, or none yet. A render brings finer and finer ones.
    std::shared_ptr<const Picture> picture;
    std::string message;        ///< "", "rendering 43 %", or why the latest attempt failed
    bool failed = false;        ///< the latest attempt did
    bool busy = true;           ///< there is, or will be, an attempt that has not ended
    std::uint64_t version = 0;  ///< grows with each change of `picture`
  };
  State state(std::size_t number) const;

  /// A rendition with the picture that it was made of, or neither.
  struct Shown {
    std::shared_ptr<const Picture> picture;
    std::shared_ptr<const Rendition> rendition;
    bool current = false;  ///< made of the present picture and LUT file
  };

  /// The present picture made ready by a method, as soon as that is done; until then what was
  /// before, which may be of another picture or another LUT file. Nothing for Method::true_colour,
  /// which needs no rendition.
  Shown shown(std::size_t number, Method method);

  /// Why the latest attempt gave nothing, as where there is no LUT file; else "".
  std::string rendition_error(std::size_t number, Method method) const;

  /// Reads or renders again although nothing changed.
  void reload(std::size_t number);

  /// The window has drawn, and what it shows is this image's: that is read and rendered first, and
  /// work that was not asked for during this drawing is dropped. A window that calls this asks in
  /// each drawing for all that it shows.
  void end_drawing(std::size_t number);

  /// For further results made of pictures and renditions: see Latest.
  Worker& worker();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace sir::viewer
