// What stands in the modeler's panel, from top to bottom: the functions of the thesis's modeler
// (3.2.2) as fields and buttons. Only in builds with Dear ImGui.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <glm/vec3.hpp>

#include "viewer/model_desk.h"

namespace sir::viewer {

/// Draws into the window that Dear ImGui has open, and does to the desk what a person did in it.
class ModelPanel {
 public:
  void draw(ModelDesk& desk);

  /// Centres of what was drawn last, by what is written on it; solids by their names in quotes.
  const std::map<std::string, std::pair<int, int>>& spots() const { return spots_; }

 private:
  using Text = std::array<char, 512>;

  void draw_solids(ModelDesk& desk);
  void draw_node(ModelDesk& desk, const std::string& solid, const modeler::Node& node,
                 std::size_t place, int depth);
  void draw_drop(const std::string& solid);
  void draw_selected(ModelDesk& desk);
  void draw_moves(ModelDesk& desk, const std::string& word, double size);
  void draw_create(ModelDesk& desk);
  void draw_combine(ModelDesk& desk);
  void draw_view(ModelDesk& desk);
  void draw_camera(ModelDesk& desk);
  void draw_light(ModelDesk& desk);
  void draw_file(ModelDesk& desk);
  void draw_commands(ModelDesk& desk);

  bool button(const char* label);
  bool part(const char* label, bool open);
  bool input(const char* label, Text& text, int flags = 0);
  void choose_solid(const ModelDesk& desk, const char* label, std::string& name);
  void note(const std::string& label);

  std::map<std::string, std::pair<int, int>> spots_;
  std::string pending_;  // a command, to be done when nothing of the list is being drawn
  std::optional<Selection> revealed_;
  bool reveal_ = false;

  // What a hand is changing: since it went down.
  glm::dvec3 moved_{0}, turned_{0}, scaled_{1};
  double factor_ = 1;

  Text new_name_{}, combined_name_{}, file_name_{}, line_{};
  int kind_ = 0, surface_ = 1, operation_ = 0;
  std::string left_, right_;
  bool open_combine_ = false;
  bool to_line_ = false;  // the command line keeps the keyboard
  std::size_t commands_ = 0;
};

}  // namespace sir::viewer
