// Which part of a picture lies where in a window: whole multiples, panned. Stands for the
// monitor's glass (thesis 3.5) and the lens before it.
#pragma once

#include <optional>

#include "viewer/letterbox.h"

namespace sir::viewer {

/// A place in a window or a picture: columns from the left, rows from the top, both from 0.
struct Place {
  int x = 0;
  int y = 0;
  friend bool operator==(const Place&, const Place&) = default;
};

/// A picture of some size seen through a window of another, each picture pixel a square of whole
/// window pixels. Along an axis where the picture is smaller than the window it is centred; where
/// it is larger it can be panned as far as its edges.
class Viewport {
 public:
  /// The window's part that is the picture's, from its upper left corner, in pixels.
  void set_window(ImageSize window);
  void set_picture(ImageSize picture);
  ImageSize window() const { return window_; }

  /// The largest multiple that fits, also when sizes change: as at first.
  void fit();
  bool fits_always() const { return chosen_ == 0; }

  /// A multiple, held within 1 to kMaxMultiple; what lies at `anchor`, a place in the window,
  /// stays there as far as the edges let it. Without an anchor the window's middle stays.
  void set_multiple(int multiple, std::optional<Place> anchor = {});
  int multiple() const;

  /// Moves the picture by so many window pixels, as far as its edges let it.
  void pan(int right, int down);

  /// Pans just so far that a pixel of the picture can be seen.
  void reveal(Place pixel);

  /// The whole picture in window pixels.
  Letterbox box() const;

  /// The picture's pixel at a place in the window; none beside the picture.
  std::optional<Place> pixel_at(Place window) const;

  /// The pixels of the picture that can be seen, at least in part; of width or height 0 where
  /// there are none.
  Letterbox visible() const;

 private:
  ImageSize window_{0, 0};
  ImageSize picture_{0, 0};
  int chosen_ = 0;  // 0: the largest that fits
  Place pan_;       // from the centred place
};

}  // namespace sir::viewer
