#include "viewer/model_desk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modeler/command_error.h"
#include "modeler/command_line.h"
#include "modeler/pick.h"
#include "modeler/script.h"
#include "modeler/view.h"
#include "tracer/atomic_file.h"
#include "tracer/error.h"
#include "tracer/scene_file.h"
#include "tracer/scene_path.h"

namespace sir::viewer {
namespace {

using Path = std::filesystem::path;
using modeler::Box;
using modeler::EntryPtr;
using modeler::Node;
using modeler::NodePtr;

// Of the image that a .CAM is for where nothing is said (thesis 3.6.2).
constexpr double kAspect = 4.0 / 3;

// All solids as one; each after its last, so that the preorder begins with as many unions.
NodePtr all_of(const modeler::Lsu& solids) {
  NodePtr all;
  for (const auto& [place, entry] : solids.entries()) {
    const NodePtr& tree = entry->solid.tree();
    all =
        all ? modeler::make_node("", modeler::Composite{Operation::union_of, std::move(all), tree})
            : tree;
  }
  return all;
}

// Which solid a node of all_of() belongs to.
std::optional<Selection> find(const modeler::Lsu& solids, std::size_t place) {
  std::size_t first = solids.size() - 1;
  for (const auto& [key, entry] : solids.entries()) {
    const std::size_t count = entry->solid.tree()->count;
    if (place < first + count) return Selection{entry->name, place - first};
    first += count;
  }
  return std::nullopt;
}

}  // namespace

ModelDesk::ModelDesk(DeskOptions options)
    : interpreter_(std::move(options.outlet)),
      orbit_(Box{}, kAspect),
      preview_(std::move(options.wake), options.threads) {}

template <typename Work>
bool ModelDesk::attempt(Work work) {
  refused_ = false;
  try {
    work();
  } catch (const modeler::CommandError& error) {
    message_ = error.what();
    refused_ = true;
  } catch (const FileError& error) {
    message_ = error.what();
    refused_ = true;
  }
  return !refused_;
}

void ModelDesk::say(const modeler::Reply& reply) {
  message_ = reply.text + reply.done;
  for (const std::string& warning : reply.warnings)
    message_ += (message_.empty() ? "warning: " : "\nwarning: ") + warning;
  changed();
  if (reply.quit) close();
}

// After a command: whatever it did, what is selected must be there.
void ModelDesk::changed() {
  dirty_ = true;
  if (selected_node() == nullptr) selection_.reset();
  if (framed_ || interpreter_.solids().empty()) return;
  framed_ = true;
  frame();
}

void ModelDesk::run_script(const Path& file) {
  interpreter_.protect(file);
  TextFile text(file);
  const bool was_framed = std::exchange(framed_, true);  // all of it, not what comes first
  modeler::run_script(text, interpreter_, [this](const modeler::Reply& reply) { say(reply); });
  framed_ = was_framed;
  changed();
}

void ModelDesk::open(const Path& base) {
  if (existing_by_suffix(base, "CAM")) {
    TextFile file(find_by_suffix(base, "CAM"));
    orbit_ = modeler::Orbit(read_camera(file));
    framed_ = true;
  }
  if (existing_by_suffix(base, "LUZ")) {
    TextFile file(find_by_suffix(base, "LUZ"));
    lighting_ = read_lighting(file);
  }
  if (existing_by_suffix(base, "SUP")) {
    TextFile file(find_by_suffix(base, "SUP"));
    surfaces_ = read_surfaces(file);
  }
  const std::string name = base.filename().string();
  say(interpreter_.execute("load " + modeler::as_word(name) + " " +
                           modeler::as_word(base.string())));
  select(Selection{name, 0});
}

bool ModelDesk::execute(const std::string& line) {
  end_drag();
  warned_ = false;
  return attempt([&] { say(interpreter_.execute(line)); });
}

bool ModelDesk::drag(const std::string& line) {
  const bool again = std::exchange(dragging_, true) && drag_done_;
  if (!again) drag_done_ = false;
  return attempt([&] {
    if (again) interpreter_.execute("undo");
    try {
      const modeler::Reply reply = interpreter_.execute(line);
      drag_done_ = !line.empty();
      say(reply);
    } catch (...) {
      if (again) interpreter_.execute("redo");
      throw;
    }
  });
}

const Node* ModelDesk::selected_node() const {
  if (!selection_) return nullptr;
  const EntryPtr entry = interpreter_.solids().find(selection_->solid);
  if (!entry) return nullptr;
  const NodePtr& tree = entry->solid.tree();
  if (selection_->place == 0) return tree.get();
  return selection_->place < tree->count ? modeler::preorder(*tree)[selection_->place] : nullptr;
}

void ModelDesk::select(std::optional<Selection> selection) {
  if (selection == selection_) return;
  selection_ = std::move(selection);
  if (selected_node() == nullptr) selection_.reset();
  dirty_ = true;
}

void ModelDesk::select_at(int column, int row) {
  const ImageSize size = picture_size();
  if (column < 0 || row < 0 || column >= size.width || row >= size.height) return;
  const NodePtr tree = shown();
  if (!tree) return;
  modeler::Picker picker(tree, camera(), size);
  const auto pick = picker.at(column, row);
  if (!pick) return select(std::nullopt);
  const bool alone = view_.alone && selection_;
  select(alone ? Selection{selection_->solid, pick->place}
               : find(interpreter_.solids(), pick->place));
}

void ModelDesk::set_view(const DeskView& view) {
  dirty_ = dirty_ || !(view == view_);
  view_ = view;
}

void ModelDesk::turn(double right, double down) {
  orbit_.turn(right, down);
  dirty_ = true;
}

void ModelDesk::pan(double right, double down) {
  orbit_.pan(right, down);
  dirty_ = true;
}

void ModelDesk::zoom(double steps) {
  orbit_.zoom(steps);
  dirty_ = true;
}

void ModelDesk::frame() {
  const NodePtr tree = shown();
  orbit_ = modeler::Orbit(tree ? tree->bounds : Box{}, kAspect);
  dirty_ = true;
}

Lighting ModelDesk::lighting() const {
  if (lighting_) return *lighting_;
  return modeler::scene_of(*modeler::make_node("", modeler::Primitive{}), camera()).lighting;
}

// What the contract of the files refuses is refused here.
bool ModelDesk::set_camera(const CameraFile& camera) {
  return attempt([&] {
    TextFile file("camera", camera_text(camera));
    orbit_ = modeler::Orbit(read_camera(file));
    framed_ = dirty_ = true;
    message_.clear();
  });
}

bool ModelDesk::set_lighting(const Lighting& lighting) {
  return attempt([&] {
    TextFile file("light", lighting_text(lighting));
    lighting_ = read_lighting(file);
    dirty_ = true;
    message_.clear();
  });
}

bool ModelDesk::save_camera(const Path& file) {
  return attempt([&] { message_ = "wrote " + modeler::save_camera(camera(), file).string(); });
}

bool ModelDesk::save_lighting(const Path& file) {
  return attempt([&] { message_ = "wrote " + modeler::save_lighting(lighting(), file).string(); });
}

bool ModelDesk::save_script(const Path& file) {
  return attempt([&] {
    const Path name = file.has_extension() ? file : with_suffix(file, "model");
    std::string text;
    for (const std::string& line : script()) text += line + "\n";
    write_file_atomically(name, text);
    message_ = "wrote " + name.string();
  });
}

void ModelDesk::set_room(ImageSize room) {
  if (room == room_) return;
  room_ = room;
  dirty_ = true;
}

ImageSize ModelDesk::picture_size() const {
  const double aspect = camera().window.x / camera().window.y;
  const auto pixels = [](double length, int most) {
    return static_cast<int>(std::clamp(std::round(length), 1.0, std::max(1.0, double(most))));
  };
  return {pixels(room_.height * aspect, room_.width), pixels(room_.width / aspect, room_.height)};
}

NodePtr ModelDesk::shown() const {
  if (!view_.alone || !selection_) return all_of(interpreter_.solids());
  return interpreter_.solids().find(selection_->solid)->solid.tree();
}

std::vector<modeler::GuideLine> ModelDesk::guides(const Node& shown) const {
  std::vector<modeler::GuideLine> lines;
  const auto add = [&](const std::vector<modeler::GuideLine>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
  };
  if (view_.grid) add(modeler::grid(shown.bounds));
  if (view_.axes) add(modeler::axes(shown.bounds));
  const Node* node = selected_node();
  if (view_.bounds && node != nullptr) add(modeler::edges(node->bounds));
  return lines;
}

void ModelDesk::refresh() {
  if (!dirty_) return;
  dirty_ = false;
  modeler::PreviewRequest request;
  request.solid = shown();
  request.camera = camera();
  request.lighting = lighting_;
  request.surfaces = surfaces_;
  request.size = picture_size();
  request.ghosts = view_.ghosts;
  request.silhouette = view_.silhouette;
  if (request.solid) request.guides = guides(*request.solid);
  preview_.request(std::move(request));
}

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
