// A modeler at hand, and what it holds as text.
#pragma once

#include <gmock/gmock.h>

#include <string>

#include "modeler/command_error.h"
#include "modeler/csg.h"
#include "modeler/interpreter.h"
#include "modeler/look_text.h"
#include "tests/temp_folder.h"
#include "tracer/scene_file.h"

namespace sir::test {

/// All solids, in their order, bit for bit.
inline std::string state_of(const modeler::Interpreter& interpreter) {
  std::string text;
  for (const auto& [place, entry] : interpreter.solids().entries())
    text += entry->name + "\n" + csg_text(modeler::to_csg(*entry->solid.tree()));
  return text;
}

/// What solids are looked at with and how, bit for bit.
inline std::string looks_of(const modeler::Interpreter& interpreter) {
  const modeler::Looks& looks = interpreter.looks();
  std::string text = modeler::camera_line(looks.camera) + "\n" +
                     modeler::light_line(looks.lighting) + "\n" +
                     surfaces_text(looks.surface_list());
  for (const std::string& line : modeler::view_lines(interpreter.view())) text += line + "\n";
  return text + modeler::select_line(interpreter.selection()) + "\n";
}

class ModelerTest : public testing::Test {
 protected:
  ModelerTest() {
    modeler::Outlet outlet;
    outlet.write_picture = [this](const std::filesystem::path& file, const Planes& picture) {
      written_to = file;
      written = picture;
    };
    outlet.draw = [](const Planes& picture, int columns) {
      return std::to_string(picture.size.width) + " in " + std::to_string(columns) + "\n";
    };
    interpreter = modeler::Interpreter(outlet);
  }

  modeler::Reply say(const std::string& line) { return interpreter.execute(line); }
  void say_all(std::initializer_list<const char*> lines) {
    for (const char* line : lines) say(line);
  }

  /// The command is refused for this reason, and all is as before.
  void expect_refused(const std::string& line, const std::string& reason) {
    const std::string before = state_of(interpreter) + looks_of(interpreter);
    const auto script = interpreter.script();
    std::string said = "(it was done)";
    try {
      say(line);
    } catch (const std::exception& error) {
      said = error.what();
    }
    EXPECT_THAT(said, testing::HasSubstr(reason)) << line;
    EXPECT_EQ(state_of(interpreter) + looks_of(interpreter), before) << line;
    EXPECT_EQ(interpreter.script(), script) << line;
  }

  const modeler::Node& solid(const std::string& name) const {
    return *interpreter.solids().find(name)->solid.tree();
  }
  bool has(const std::string& name) const { return interpreter.solids().find(name) != nullptr; }
  Placement placement(const std::string& name) const { return solid(name).primitive()->local_cena; }

  TempFolder folder;
  modeler::Interpreter interpreter;
  std::filesystem::path written_to;
  Planes written;
};

}  // namespace sir::test
