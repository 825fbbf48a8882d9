// What stands in the modeler's panel, from top to bottom: the functions of the thesis's modeler
// (3.2.2) as fields and buttons. Only in builds with Dear ImGui.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "viewer/model_desk.h"
#include "viewer/model_files.h"
#include "viewer/model_hand.h"
#include "viewer/model_line.h"
#include "viewer/model_offer.h"
#include "viewer/tree_rows.h"

namespace sir::viewer {

/// Draws into the window that Dear ImGui has open, and gives the desk what a person did in it as
/// commands; it has nothing to say of solids, looks, view or selection itself.
class ModelPanel {
 public:
  void draw(ModelDesk& desk, ModelHand& hand);

  /// The dialogs that keys open.
  ModelFiles& files() { return files_; }

  /// Asks, before anything is done, what is to become of sessions that were not ended.
  void offer(std::vector<modeler::KeptSession> sessions) { offer_.open(std::move(sessions)); }

  /// Centres of what was drawn last, by what is written on it; solids by their names in quotes.
  const std::map<std::string, std::pair<int, int>>& spots() const { return spots_; }

 private:
  using Text = std::array<char, 512>;

  void draw_tools(ModelDesk& desk, ModelHand& hand);
  void draw_view(const ModelDesk& desk);
  void draw_solids(const ModelDesk& desk);
  void draw_row(const ModelDesk& desk, const TreeRow& row);
  void draw_drop(const std::string& solid);
  void draw_selected(ModelDesk& desk);
  void draw_name(const modeler::Selection& what, const modeler::Node& node);
  void draw_moves(ModelDesk& desk, const modeler::Selection& what, const modeler::Node& node);
  void draw_surfaces_of(ModelDesk& desk, const modeler::Selection& what, const modeler::Node& node);
  void draw_operation_of(const modeler::Selection& what, const modeler::Composite& composite);
  void draw_create(ModelDesk& desk);
  void draw_combine(ModelDesk& desk);
  void draw_camera(ModelDesk& desk);
  void draw_light(ModelDesk& desk);
  void draw_surfaces(ModelDesk& desk);
  void draw_coefficients(ModelDesk& desk, const Surface& surface, bool odd);
  void draw_commands(ModelDesk& desk);

  bool button(const char* label);
  bool part(const char* label, bool open);
  bool input(const char* label, Text& text, int flags = 0);
  void choose_solid(const ModelDesk& desk, const char* label, std::string& name);
  bool choose_surface(const ModelDesk& desk, const char* label, std::int64_t& number);
  glm::dvec3 colour_of(const ModelDesk& desk, std::int64_t surface) const;
  void note(const std::string& label);

  std::map<std::string, std::pair<int, int>> spots_;
  std::vector<std::string> pending_;  // commands, to be done when nothing is being drawn
  ModelFiles files_;
  ModelLine line_;
  ModelOffer offer_;

  TreeRows rows_;
  Text filter_{};
  std::optional<modeler::Selection> revealed_;
  bool reveal_ = false;

  // What a hand is changing: since it went down.
  glm::dvec3 moved_{0}, turned_{0}, scaled_{1};
  double factor_ = 1;

  Text new_name_{}, combined_name_{}, name_{};
  std::optional<modeler::Selection> named_;  // whose name stands in the field
  std::string written_;                      // the name it had then
  int kind_ = 0, operation_ = 0;
  std::int64_t surface_ = 1, described_ = 1;
  std::string left_, right_;
  bool open_combine_ = false;
  unsigned active_ = 0;  // the field that a hand holds, as Dear ImGui numbers it; 0: none
  std::size_t commands_ = 0;
};

}  // namespace sir::viewer
