#include "viewer/model_desk.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "modeler/command_error.h"
#include "modeler/command_line.h"
#include "modeler/look_text.h"
#include "modeler/script.h"
#include "tracer/error.h"
#include "tracer/scene_path.h"

namespace sir::viewer {
namespace {

using Path = std::filesystem::path;
using modeler::as_word;
using modeler::Node;
using modeler::NodePtr;

}  // namespace

ModelDesk::ModelDesk(DeskOptions options)
    : interpreter_(std::move(options.outlet)), preview_(std::move(options.wake), options.threads) {
  if (options.journals)
    keeper_ = std::make_unique<modeler::Keeper>(interpreter_, *options.journals, options.from);
}

template <typename Work>
bool ModelDesk::attempt(Work work) {
  script_known_ = false;
  try {
    work();
    return true;
  } catch (const modeler::CommandError& error) {
    message_ = error.what();
  } catch (const FileError& error) {
    message_ = error.what();
  }
  refused_ = true;
  return false;
}

void ModelDesk::say(const modeler::Reply& reply) {
  refused_ = false;
  message_ = reply.text + reply.done;
  for (const std::string& warning : reply.warnings)
    message_ += (message_.empty() ? "warning: " : "\nwarning: ") + warning;
  dirty_ = true;
  if (reply.quit) close();
}

// For what is seen to be done: only a refusal is said, and one that was said is gone.
bool ModelDesk::quietly(const std::string& line) {
  return attempt([&] {
    const modeler::Reply reply = interpreter_.execute(line);
    dirty_ = true;
    if (!reply.warnings.empty()) say(reply);
    if (std::exchange(refused_, false)) message_.clear();
  });
}

const std::vector<std::string>& ModelDesk::script() const {
  if (!std::exchange(script_known_, true)) script_ = interpreter_.script();
  return script_;
}

bool ModelDesk::try_script(const Path& file) {
  end_drag();
  warned_ = false;
  return attempt([&] { run_script(file); });
}

void ModelDesk::run_script(const Path& file) {
  script_known_ = false;
  interpreter_.protect(file);
  TextFile text(file);
  interpreter_.watch(false);
  modeler::run_script(text, interpreter_, [this](const modeler::Reply& reply) { say(reply); });
  interpreter_.release(file);
}

void ModelDesk::open(const Path& base) {
  script_known_ = false;
  const std::string name = as_word(base.filename().string());
  const auto loaded = interpreter_.execute("load " + name + " " + as_word(base.string()));
  constexpr std::pair<const char*, const char*> kLooks[] = {
      {"CAM", "camera"}, {"LUZ", "light"}, {"SUP", "surfaces"}};
  for (const auto& [suffix, word] : kLooks)
    if (const auto file = existing_by_suffix(base, suffix))
      interpreter_.execute(std::string(word) + " load " + as_word(file->string()));
  interpreter_.execute("select " + name);
  say(loaded);
}

bool ModelDesk::execute(const std::string& line) {
  const bool in_hand = dragging_ || cut_off_;
  end_drag();
  cut_off_ = in_hand;
  warned_ = false;
  interpreter_.watch(true);
  return attempt([&] { say(interpreter_.execute(line)); });
}

bool ModelDesk::drag(const std::string& line) {
  if (cut_off_) return true;
  const bool again = std::exchange(dragging_, true) && drag_done_;
  if (!again) drag_done_ = false;
  warned_ = false;
  interpreter_.hold_camera();
  return attempt([&] {
    if (again) interpreter_.execute("undo");
    const std::size_t before = interpreter_.undoable();
    try {
      const modeler::Reply reply = interpreter_.execute(line);
      drag_done_ = interpreter_.undoable() > before;
      say(reply);
    } catch (...) {
      if (again) interpreter_.execute("redo");
      throw;
    }
  });
}

void ModelDesk::end_drag() {
  cut_off_ = false;
  dragging_ = false;
  interpreter_.let_go_of_camera();
}

const Node* ModelDesk::selected_node() const {
  const auto& chosen = selection();
  if (!chosen) return nullptr;
  return modeler::node_at(*interpreter_.solids().find(chosen->solid)->solid.tree(), chosen->place);
}

bool ModelDesk::select(const std::optional<Selection>& selection) {
  return selection == this->selection() || quietly(modeler::select_line(selection));
}

void ModelDesk::select_at(int column, int row) {
  const auto found = probe(column, row);
  select(found ? std::optional(found->what) : std::nullopt);
}

std::optional<Probed> ModelDesk::probe(int column, int row) {
  try {
    return probe_.at(interpreter_, picture_size(), column, row);
  } catch (const std::exception&) {
    return std::nullopt;  // what cannot be traced has no picture either: trouble() says why
  }
}

void ModelDesk::set_view(const ViewSettings& wanted) {
  for (const std::string& line : modeler::view_lines(wanted, view())) quietly(line);
}

bool ModelDesk::turn(double right, double down) {
  interpreter_.hold_camera();
  return quietly(fmt::format("camera turn {} {}", right, down));
}

bool ModelDesk::pan(double right, double down) {
  interpreter_.hold_camera();
  return quietly(fmt::format("camera pan {} {}", right, down));
}

bool ModelDesk::zoom(double steps) {
  interpreter_.hold_camera();
  return quietly(fmt::format("camera zoom {}", steps));
}

bool ModelDesk::set_camera(const CameraFile& camera) {
  interpreter_.hold_camera();
  return quietly(modeler::camera_line(camera));
}

bool ModelDesk::set_lighting(const Lighting& lighting) {
  return drag(modeler::light_line(lighting));
}

bool ModelDesk::frame() {
  end_drag();
  const bool alone = view().alone && selection();
  return quietly("camera frame" + (alone ? " " + as_word(selection()->solid) : ""));
}

bool ModelDesk::save_camera(const Path& file) {
  return execute("camera save " + as_word(file.string()));
}

bool ModelDesk::save_lighting(const Path& file) {
  return execute("light save " + as_word(file.string()));
}

bool ModelDesk::save_surfaces(const Path& file) {
  return execute("surfaces save " + as_word(file.string()));
}

bool ModelDesk::save_script(const Path& file) {
  return execute("script save " + as_word(file.string()));
}

void ModelDesk::set_room(ImageSize room) {
  if (room == room_) return;
  room_ = room;
  dirty_ = true;
}

ImageSize ModelDesk::picture_size() const {
  const glm::dvec2 window = camera().window;
  const double aspect = window.x / window.y;
  const auto pixels = [](double length, int most) {
    return static_cast<int>(std::clamp(std::round(length), 1.0, std::max(1.0, double(most))));
  };
  return {pixels(room_.height * aspect, room_.width), pixels(room_.width / aspect, room_.height)};
}

std::vector<modeler::GuideLine> ModelDesk::guides(const Node& shown) const {
  std::vector<modeler::GuideLine> lines;
  const auto add = [&](const std::vector<modeler::GuideLine>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
  };
  if (view().grid) add(modeler::grid(shown.bounds));
  if (view().axes) add(modeler::axes(shown.bounds));
  const Node* node = selected_node();
  if (view().bounds && node != nullptr) add(modeler::edges(node->bounds));
  return lines;
}

void ModelDesk::refresh() {
  if (!dirty_) return;
  dirty_ = false;
  modeler::PreviewRequest request;
  request.solid = probe_.shown(interpreter_);
  request.camera = camera();
  request.lighting = interpreter_.looks().lighting;
  request.surfaces = interpreter_.looks().surface_list();
  request.size = picture_size();
  request.ghosts = view().ghosts;
  request.silhouette = view().silhouette;
  if (request.solid) request.guides = guides(*request.solid);
  preview_.request(std::move(request));
}

void ModelDesk::begin() {
  if (keeper_) keeper_->begin();
}

std::vector<modeler::KeptSession> ModelDesk::kept() const {
  return keeper_ && !keeper_->recovered() ? keeper_->sessions()
                                          : std::vector<modeler::KeptSession>();
}

std::string ModelDesk::end() { return keeper_ ? keeper_->end() : std::string(); }

void ModelDesk::close() {
  const std::vector<std::string> unsaved = interpreter_.unsaved();
  closed_ = unsaved.empty() || std::exchange(warned_, true);
  if (closed_) return;
  refused_ = true;
  message_ = "not saved: ";
  for (const std::string& name : unsaved)
    message_ += (&name == &unsaved.front() ? "" : ", ") + in_quotes(name);
  message_ += "; close again to leave";
}

}  // namespace sir::viewer
