// The modeler's window without the window: solids, what is selected, how they are looked at. What
// menus did in the thesis (3.2) are commands here, whoever gives them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "modeler/interpreter.h"
#include "modeler/orbit.h"
#include "modeler/preview.h"

namespace sir::viewer {

struct DeskOptions {
  modeler::Outlet outlet;
  std::function<void()> wake = [] {};  ///< as of modeler::Preview
  int threads = 0;                     ///< of the tracer; 0: as many as cores
};

/// What is shown besides the solids.
struct DeskView {
  bool ghosts = false, axes = true, bounds = true, grid = false, silhouette = false;
  bool alone = false;  ///< the selected solid alone; else all of the list
  friend bool operator==(const DeskView&, const DeskView&) = default;
};

/// A node of a solid: a place in preorder() of its tree, 0 the solid itself.
struct Selection {
  std::string solid;
  std::size_t place = 0;
  friend bool operator==(const Selection&, const Selection&) = default;
};

/// Solids are changed by commands only, so that script() tells all that was done to them; camera,
/// light and surfaces are looks, as in BASE.CAM, .LUZ and .SUP. What is refused leaves everything,
/// the picture too, as it was, and message() says why. For one thread; nothing waits.
class ModelDesk {
 public:
  explicit ModelDesk(DeskOptions options);

  /// Does a script's commands. Throws FileError.
  void run_script(const std::filesystem::path& file);

  /// Loads BASE.CSG under the name of BASE, and takes BASE.CAM, .LUZ and .SUP where they are.
  /// Throws FileError.
  void open(const std::filesystem::path& base);

  /// Does one command; false where it is refused.
  bool execute(const std::string& line);

  /// The same for a change that a hand is still making: the command takes the place of the last one
  /// that was given so, until end_drag(). An empty one: no change.
  bool drag(const std::string& line);
  void end_drag() { dragging_ = false; }

  const modeler::Interpreter& interpreter() const { return interpreter_; }
  std::vector<std::string> script() const { return interpreter_.script(); }

  /// What the last command had to say, or why it was refused.
  const std::string& message() const { return message_; }
  bool refused() const { return refused_; }

  /// The node that is selected; none where its solid is gone.
  const std::optional<Selection>& selection() const { return selection_; }
  const modeler::Node* selected_node() const;
  void select(std::optional<Selection> selection);
  void select_at(int column, int row);  ///< of the picture; the background selects nothing

  const DeskView& view() const { return view_; }
  void set_view(const DeskView& view);

  void turn(double right, double down);
  void pan(double right, double down);
  void zoom(double steps);
  void frame();  ///< the camera that has all of it, or the selected solid, in its window

  const CameraFile& camera() const { return orbit_.camera(); }
  Lighting lighting() const;  ///< the made-up one of the camera until it is set
  bool set_camera(const CameraFile& camera);
  bool set_lighting(const Lighting& lighting);

  /// FILE.CAM, FILE.LUZ, FILE (.model where it has no suffix). False where it cannot be written.
  bool save_camera(const std::filesystem::path& file);
  bool save_lighting(const std::filesystem::path& file);
  bool save_script(const std::filesystem::path& file);

  /// The room for the picture, which takes as much of it as the camera's window has the shape for.
  void set_room(ImageSize room);
  ImageSize picture_size() const;

  /// Asks for a new picture where something changed.
  void refresh();
  std::shared_ptr<const modeler::PreviewPicture> picture() const { return preview_.take(); }

  /// Whether the picture is not yet that of what there is.
  bool busy() const { return dirty_ || preview_.busy(); }

  /// Asks to leave: refused once where solids are not saved.
  void close();
  bool closed() const { return closed_; }

 private:
  template <typename Work>
  bool attempt(Work work);
  void say(const modeler::Reply& reply);
  void changed();
  modeler::NodePtr shown() const;
  std::vector<modeler::GuideLine> guides(const modeler::Node& shown) const;

  modeler::Interpreter interpreter_;
  std::string message_;
  bool refused_ = false, closed_ = false, warned_ = false;
  bool dragging_ = false, drag_done_ = false;
  std::optional<Selection> selection_;
  DeskView view_;
  modeler::Orbit orbit_;
  bool framed_ = false;
  std::optional<Lighting> lighting_;
  std::vector<Surface> surfaces_;
  ImageSize room_;
  bool dirty_ = true;
  modeler::Preview preview_;  // the last member: its thread wakes the others
};

}  // namespace sir::viewer
