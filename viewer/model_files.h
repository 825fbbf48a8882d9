// Opening and saving in the modeler's window: which kinds of files there are, and the commands that
// they come to (salva and carrega sólido, thesis 3.2.2.7, 3.2.2.8; the files of 3.6). Only in
// builds with Dear ImGui.
#pragma once

#include <functional>
#include <string>

#include "viewer/file_dialog.h"
#include "viewer/model_desk.h"

namespace sir::viewer {

class ModelFiles {
 public:
  using Note = std::function<void(const std::string& label)>;

  /// The lines of the menu, in one that is open.
  void draw_menu(ModelDesk& desk, const Note& note);

  /// The dialog, where one is open; does what was chosen.
  void draw(ModelDesk& desk, const Note& note);

  /// BASE.CSG under a name that is free, and BASE.CAM, .LUZ and .SUP where they are.
  void open_scene();
  void run_script();
  void load_solid();
  void load(const std::string& what, const char* suffix);  ///< what: camera, light, surfaces

  /// The selected solid; where none is, all of it as a script.
  void save(const ModelDesk& desk);
  void save_solid(const std::string& solid);
  void save(const std::string& what, const char* suffix);
  void save_script();

 private:
  void ask(FileDialog::Wanted wanted,
           std::function<void(ModelDesk& desk, const std::filesystem::path& file)> work);

  FileDialog dialog_;
  std::function<void(ModelDesk&)> chosen_;
};

}  // namespace sir::viewer
