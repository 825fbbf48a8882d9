// Where the camera has been: who edits, goes around to look and then undoes wants the edit undone,
// so the camera has an undo of its own.
#pragma once

#include <optional>
#include <vector>

#include "tracer/scene.h"

namespace sir::modeler {

/// The cameras before the one there is, and after it; none: a made-up one.
class CameraHistory {
 public:
  /// Before a change: what there is. Nothing can be redone after it.
  void remember(const std::optional<CameraFile>& now);

  /// Changes from here on are one, until let_go(): a hand moves the camera.
  void hold();
  void let_go() { held_ = false; }

  /// Whether the next change goes on with the last; so as it was once, for doing it again.
  bool in_hand() const { return held_ && begun_; }
  void take_in_hand(bool in_hand) { held_ = begun_ = in_hand; }

  /// Where there is one, takes it for `now`, and remembers `now` for the other way.
  bool undo(std::optional<CameraFile>& now);
  bool redo(std::optional<CameraFile>& now);

 private:
  std::vector<std::optional<CameraFile>> before_, after_;
  bool held_ = false;
  bool begun_ = false;  // something has changed since hold()
};

/// Whether two cameras are the same, number for number.
bool same(const CameraFile& a, const CameraFile& b);
bool same(const std::optional<CameraFile>& a, const std::optional<CameraFile>& b);

}  // namespace sir::modeler
