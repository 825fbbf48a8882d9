#include "viewer/model_files.h"

#include <imgui.h>

#include <utility>

#include "modeler/command_line.h"
#include "modeler/operations.h"
#include "tracer/scene_path.h"

namespace sir::viewer {
namespace {

using Path = std::filesystem::path;
using modeler::as_word;

std::string word_of(const Path& file) { return as_word(as_written(file).string()); }

// As a name of the list, which a file's name may not be fit to be.
std::string name_for(const ModelDesk& desk, const Path& base) {
  std::string name = readable(base.filename().native());
  const auto first = name.find_first_not_of(' '), last = name.find_last_not_of(' ');
  name = first == name.npos ? "solid" : name.substr(first, last + 1 - first);
  return modeler::free_name(desk.interpreter().solids(), name);
}

void open(ModelDesk& desk, const Path& file) {
  const Path base = Path(file).replace_extension();
  const std::string name = name_for(desk, base);
  if (!desk.execute("load " + as_word(name) + " " + word_of(file))) return;
  for (const auto& [what, suffix] :
       {std::pair{"camera", "CAM"}, std::pair{"light", "LUZ"}, std::pair{"surfaces", "SUP"}})
    if (const auto beside = existing_by_suffix(base, suffix))
      if (!desk.execute(std::string(what) + " load " + word_of(*beside))) return;
  desk.execute("select " + as_word(name));
}

}  // namespace

void ModelFiles::draw_menu(ModelDesk& desk, const Note& note) {
  const auto item = [&](const char* label, const char* keys = nullptr, bool enabled = true) {
    const bool chosen = ImGui::MenuItem(label, keys, false, enabled);
    note(label);
    return chosen;
  };
  if (item("Open scene...", "Ctrl+O")) open_scene();
  if (item("Run script...")) run_script();
  ImGui::Separator();
  if (item("Load solid...")) load_solid();
  if (item("Load camera...")) load("camera", "CAM");
  if (item("Load light...")) load("light", "LUZ");
  if (item("Load surfaces...")) load("surfaces", "SUP");
  ImGui::Separator();
  const auto& selection = desk.interpreter().selection();
  if (item("Save solid...", "Ctrl+S", selection.has_value())) save_solid(selection->solid);
  if (item("Save camera...")) save("camera", "CAM");
  if (item("Save light...")) save("light", "LUZ");
  if (item("Save surfaces...")) save("surfaces", "SUP");
  if (item("Save script...", "Ctrl+Shift+S")) save_script();
  ImGui::Separator();
  if (item("Quit")) desk.execute("quit");
}

void ModelFiles::draw(ModelDesk& desk, const Note& note) {
  dialog_.draw(note);
  if (!chosen_) return;
  std::exchange(chosen_, nullptr)(desk);
}

void ModelFiles::ask(FileDialog::Wanted wanted, std::function<void(ModelDesk&, const Path&)> work) {
  wanted.button = wanted.to_save ? "Save" : "Open";
  wanted.chosen = [this, work = std::move(work)](const Path& file) {
    chosen_ = [work, file](ModelDesk& desk) { work(desk, file); };
  };
  dialog_.open(std::move(wanted));
}

void ModelFiles::open_scene() { ask({.title = "Open a scene", .suffixes = {"CSG"}}, open); }

void ModelFiles::run_script() {
  ask({.title = "Run a script", .suffixes = {"model"}},
      [](ModelDesk& desk, const Path& file) { desk.try_script(as_written(file)); });
}

void ModelFiles::load_solid() {
  ask({.title = "Load a solid", .suffixes = {"CSG"}}, [](ModelDesk& desk, const Path& file) {
    const std::string name = name_for(desk, Path(file).replace_extension());
    if (desk.execute("load " + as_word(name) + " " + word_of(file)))
      desk.execute("select " + as_word(name));
  });
}

void ModelFiles::load(const std::string& what, const char* suffix) {
  ask({.title = "Load the " + what, .suffixes = {suffix}},
      [what](ModelDesk& desk, const Path& file) { desk.execute(what + " load " + word_of(file)); });
}

void ModelFiles::save(const ModelDesk& desk) {
  const auto& selection = desk.interpreter().selection();
  if (selection) save_solid(selection->solid);
  else save_script();
}

void ModelFiles::save_solid(const std::string& solid) {
  // A name may hold what would lead elsewhere.
  std::string proposed = solid;
  for (char& letter : proposed)
    if (letter == '/') letter = '-';
  ask({.title = "Save the solid",
       .suffixes = {"CSG", "model"},
       .to_save = true,
       .proposed = proposed + ".CSG"},
      [solid](ModelDesk& desk, const Path& file) {
        desk.execute("save " + as_word(solid) + " " + word_of(file));
      });
}

void ModelFiles::save(const std::string& what, const char* suffix) {
  ask({.title = "Save the " + what, .suffixes = {suffix}, .to_save = true},
      [what](ModelDesk& desk, const Path& file) { desk.execute(what + " save " + word_of(file)); });
}

void ModelFiles::save_script() {
  ask({.title = "Save the script", .suffixes = {"model"}, .to_save = true},
      [](ModelDesk& desk, const Path& file) { desk.execute("script save " + word_of(file)); });
}

}  // namespace sir::viewer
