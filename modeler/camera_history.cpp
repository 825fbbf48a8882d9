#include "modeler/camera_history.h"

#include <utility>

namespace sir::modeler {
namespace {

using Camera = std::optional<CameraFile>;

bool move(std::vector<Camera>& from, std::vector<Camera>& to, Camera& now) {
  if (from.empty()) return false;
  to.push_back(std::exchange(now, std::move(from.back())));
  from.pop_back();
  return true;
}

}  // namespace

void CameraHistory::remember(const Camera& now) {
  after_.clear();
  if (held_ && std::exchange(begun_, true)) return;
  before_.push_back(now);
}

void CameraHistory::hold() {
  if (!std::exchange(held_, true)) begun_ = false;
}

bool CameraHistory::undo(Camera& now) {
  let_go();
  return move(before_, after_, now);
}

bool CameraHistory::redo(Camera& now) {
  let_go();
  return move(after_, before_, now);
}

bool same(const CameraFile& a, const CameraFile& b) {
  return a.window == b.window && a.target == b.target && a.normal == b.normal &&
         a.distance == b.distance && a.up == b.up && a.parallel == b.parallel &&
         a.focal == b.focal && a.focal_given == b.focal_given;
}

bool same(const Camera& a, const Camera& b) {
  return a && b ? same(*a, *b) : a.has_value() == b.has_value();
}

}  // namespace sir::modeler
