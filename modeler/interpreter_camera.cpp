// The camera by commands (thesis 3.6.2).
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "modeler/arguments.h"
#include "modeler/command_error.h"
#include "modeler/interpreter.h"
#include "modeler/look_files.h"
#include "modeler/look_text.h"
#include "modeler/look_words.h"
#include "modeler/operations.h"
#include "modeler/orbit.h"
#include "modeler/refusal.h"
#include "modeler/sampling.h"
#include "tracer/scene_file.h"

namespace sir::modeler {
namespace {

// Of the image that a .CAM is for where nothing is said (thesis 3.6.2).
constexpr double kAspect = 4.0 / 3;

// Of the window as it is; to rounding, that of every image.
double aspect_of(const std::optional<CameraFile>& camera) {
  constexpr double kRounding = 1e-9;
  if (!camera) return kAspect;
  const double aspect = camera->window.x / camera->window.y;
  return std::abs(aspect - kAspect) < kRounding ? kAspect : aspect;
}

// Where there is something of them: what a difference takes away need not be in the window.
Box filled_box(const Lsu& solids, const std::stop_token& stop) {
  Box all;
  for (const auto& [place, entry] : solids.entries())
    all = combined(Operation::union_of, all, filled_box(*entry->solid.tree(), stop));
  if (stop.stop_requested()) throw CommandError("interrupted");
  return all;
}

// What the file could not hold is refused.
CameraFile checked(CameraFile camera) {
  if (!camera.focal_given) camera.focal = camera.distance;
  if (!(camera.focal > 0) && camera.focal_given)
    throw CommandError("the focal distance must be > 0");
  refusing([&] {
    TextFile file("camera", camera_text(camera));
    read_camera(file);
  });
  return camera;
}

}  // namespace

CameraFile Interpreter::camera() const {
  if (looks_.camera) return *looks_.camera;
  if (solids_.empty()) made_up_camera_.reset();
  if (solids_.empty()) return Orbit(Box{}, kAspect).camera();
  if (!made_up_camera_)
    made_up_camera_ = Orbit(filled_box(solids_, outlet_.stop), kAspect).camera();
  return *made_up_camera_;
}

Reply Interpreter::camera_command(Arguments& words) {
  if (words.left() == 0)
    return {camera_line(camera()) + (looks_.camera ? "" : "  # made up") + "\n", {}, {}, false};
  Orbit orbit(camera());
  switch (value_of(camera_words(), words.peek(), "word of camera")) {
    case CameraWord::load: {
      words.next();
      TextFile file = read(file_word(words), "CAM");
      words.end();
      return set_camera(read_camera(file), "camera: that of " + file.name());
    }
    case CameraWord::save: {
      words.next();
      const std::filesystem::path file = file_to_write(file_word(words), "CAM");
      words.end();
      require_writable(file);
      write(file, camera_text(camera()));
      return noted(words, file, {{}, "wrote " + file.string(), {}, false}, camera());
    }
    case CameraWord::frame: {
      words.next();
      const Box box = words.left() > 0
                          ? filled_box(*require(solids_, words.next())->solid.tree(), outlet_.stop)
                          : filled_box(solids_, outlet_.stop);
      words.end();
      if (outlet_.stop.stop_requested()) throw CommandError("interrupted");
      return set_camera(Orbit(box, aspect_of(looks_.camera)).camera(), "camera: framed");
    }
    case CameraWord::turn:
    case CameraWord::pan: {
      const bool turns =
          value_of(camera_words(), words.next(), "word of camera") == CameraWord::turn;
      const double right = words.number(), down = words.number();
      words.end();
      if (turns) orbit.turn(right, down);
      else orbit.pan(right, down);
      return set_camera(orbit.camera(), "camera: moved");
    }
    case CameraWord::zoom:
      words.next();
      orbit.zoom(words.number());
      words.end();
      return set_camera(orbit.camera(), "camera: moved");
    case CameraWord::made_up:
      words.next();
      words.end();
      made_up_camera_.reset();
      return set_camera(std::nullopt, "camera: made up");
    default: return set_camera(described_camera(words), "camera: set");
  }
}

CameraFile Interpreter::described_camera(Arguments& words) const {
  CameraFile described = camera();
  while (words.left() > 0) {
    switch (value_of(camera_words(), words.next(), "word of camera")) {
      case CameraWord::window:
        described.window.x = words.number();
        described.window.y = words.number();
        break;
      case CameraWord::target: described.target = words.vector(); break;
      case CameraWord::normal: described.normal = words.vector(); break;
      case CameraWord::distance: described.distance = words.number(); break;
      case CameraWord::up: described.up = words.vector(); break;
      case CameraWord::focal:
        described.focal_given = words.left() == 0 || !is_word(words.peek(), "auto", "automática");
        if (described.focal_given) described.focal = words.number();
        else words.next();
        break;
      case CameraWord::parallel: described.parallel = true; break;
      case CameraWord::perspective: described.parallel = false; break;
      default: words.fail();
    }
  }
  return described;
}

Reply Interpreter::set_camera(std::optional<CameraFile> camera, std::string done) {
  if (camera) camera = checked(*camera);
  changed_ = true;
  if (!same(camera, looks_.camera)) {
    camera_history_.remember(looks_.camera);
    looks_.camera = std::move(camera);
  }
  return {{}, std::move(done), {}, false};
}

Reply Interpreter::take_camera_back(bool again) {
  const bool done =
      again ? camera_history_.redo(looks_.camera) : camera_history_.undo(looks_.camera);
  if (!done)
    throw CommandError(again ? "there is no camera to go on to"
                             : "there is no camera to go back to");
  changed_ = true;
  return {{}, again ? "camera: moved again" : "camera: as it was", {}, false};
}

}  // namespace sir::modeler
