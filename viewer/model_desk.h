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
#include "modeler/keeper.h"
#include "modeler/preview.h"
#include "viewer/model_probe.h"

namespace sir::viewer {

struct DeskOptions {
  modeler::Outlet outlet;
  std::function<void()> wake = [] {};  ///< as of modeler::Preview
  int threads = 0;                     ///< of the tracer; 0: as many as cores
  /// Where journals are (modeler/keeper.h); empty: there is no such place; none: nothing is kept.
  std::optional<std::filesystem::path> journals = {};
  std::string from = {};  ///< what the session begins with, for its journal
};

using modeler::Selection;
using modeler::ViewSettings;

/// Whatever is done here is a command given to the interpreter, which holds all that there is:
/// script() makes it again. What is refused leaves everything, the picture too, as it was, and
/// message() says why. For one thread; nothing waits.
class ModelDesk {
 public:
  explicit ModelDesk(DeskOptions options);

  /// Does a script's commands. Throws FileError.
  void run_script(const std::filesystem::path& file);

  /// Loads BASE.CSG under the name of BASE, and takes BASE.CAM, .LUZ and .SUP where they are.
  /// Throws FileError.
  void open(const std::filesystem::path& base);

  /// The same for a person who looks on: false where a command is refused, which message() tells.
  /// What was done before it stays done.
  bool try_script(const std::filesystem::path& file);

  /// Does one command; false where it is refused.
  bool execute(const std::string& line);

  /// The same for a change that a hand is still making: the command takes the place of the last one
  /// that was given so, until end_drag(). An empty one: no change. Those of the camera come one
  /// after the other, and `undo camera` takes them back as one. Where another command came in
  /// between, as an undo by a key, what the hand goes on to do is passed over: its change began
  /// with what is no longer there.
  bool drag(const std::string& line);
  void end_drag();

  const modeler::Interpreter& interpreter() const { return interpreter_; }
  const std::vector<std::string>& script() const;

  /// What the last command had to say, or why it was refused.
  const std::string& message() const { return message_; }
  bool refused() const { return refused_; }

  /// The node that is selected; none where its solid is gone.
  const std::optional<Selection>& selection() const { return interpreter_.selection(); }
  const modeler::Node* selected_node() const;
  bool select(const std::optional<Selection>& selection);
  void select_at(int column, int row);  ///< of the picture; the background selects nothing

  /// What is at a pixel of the picture.
  std::optional<Probed> probe(int column, int row);

  const ViewSettings& view() const { return interpreter_.view(); }
  void set_view(const ViewSettings& view);

  /// By the mouse; each is part of a drag.
  bool turn(double right, double down);
  bool pan(double right, double down);
  bool zoom(double steps);
  bool set_camera(const CameraFile& camera);
  bool set_lighting(const Lighting& lighting);
  bool frame();  ///< the camera that has all of it, or the selected solid alone, in its window

  CameraFile camera() const { return interpreter_.camera(); }
  Lighting lighting() const { return interpreter_.lighting(); }

  /// FILE.CAM, FILE.LUZ, FILE.SUP, FILE (.model where it has no suffix). False where it cannot be
  /// written.
  bool save_camera(const std::filesystem::path& file);
  bool save_lighting(const std::filesystem::path& file);
  bool save_surfaces(const std::filesystem::path& file);
  bool save_script(const std::filesystem::path& file);

  /// The room for the picture, which takes as much of it as the camera's window has the shape for.
  void set_room(ImageSize room);
  ImageSize picture_size() const;

  /// Asks for a new picture where something changed.
  void refresh();
  std::shared_ptr<const modeler::PreviewPicture> picture() const { return preview_.take(); }

  /// Why there is no picture of what there is; "" where there is one, or will be.
  std::string trouble() const { return preview_.error(); }

  /// Whether the picture is not yet that of what there is.
  bool busy() const { return dirty_ || preview_.busy(); }

  /// What has been done so far was not done by a person. From here on it is.
  void begin();

  /// Sessions that can be recovered, the last one first; none where one has been.
  std::vector<modeler::KeptSession> kept() const;

  /// Ends the journal, as of a session that is over: a line that says so where it stays, else "".
  std::string end();

  /// Asks to leave: refused once where solids are not saved.
  void close();
  bool closed() const { return closed_; }

 private:
  template <typename Work>
  bool attempt(Work work);
  void say(const modeler::Reply& reply);
  bool quietly(const std::string& line);
  std::vector<modeler::GuideLine> guides(const modeler::Node& shown) const;

  modeler::Interpreter interpreter_;
  std::unique_ptr<modeler::Keeper> keeper_;
  std::string message_;
  bool refused_ = false, closed_ = false, warned_ = false;
  bool dragging_ = false;
  bool cut_off_ = false;                     // by another command, until the hand lets go
  bool drag_done_ = false;                   // the last command of the drag can be undone
  mutable std::vector<std::string> script_;  // once it was asked for
  mutable bool script_known_ = false;
  ModelProbe probe_;
  ImageSize room_;
  bool dirty_ = true;
  modeler::Preview preview_;  // the last member: its thread wakes the others
};

}  // namespace sir::viewer
