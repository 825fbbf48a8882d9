#include "viewer/model_probe.h"

#include <fmt/format.h>

#include "modeler/operations.h"
#include "tracer/names.h"
#include "tracer/text_file.h"

namespace sir::viewer {
namespace {

using modeler::NodePtr;

// Each solid after its last, so that the preorder begins with as many unions.
NodePtr as_one(const std::vector<NodePtr>& parts) {
  NodePtr all;
  for (const NodePtr& tree : parts)
    all =
        all ? modeler::make_node("", modeler::Composite{Operation::union_of, std::move(all), tree})
            : tree;
  return all;
}

bool is_alone(const modeler::Interpreter& interpreter) {
  return interpreter.view().alone && interpreter.selection();
}

// Which solid a node of as_one() belongs to.
modeler::Selection find(const modeler::Interpreter& interpreter, const modeler::Pick& pick) {
  if (is_alone(interpreter)) return {interpreter.selection()->solid, pick.place, pick.face};
  const auto& entries = interpreter.solids().entries();
  std::size_t first = entries.size() - 1;
  for (const auto& [place, entry] : entries) {
    const std::size_t count = entry->solid.tree()->count;
    if (pick.place < first + count) return {entry->name, pick.place - first, pick.face};
    first += count;
  }
  return {};
}

}  // namespace

std::string text_of(const Probed& probed) {
  const modeler::Node& node = *probed.pick.node;
  const auto& point = probed.pick.point;
  const std::string name = probed.what.place == 0
                               ? in_quotes(probed.what.solid)
                               : fmt::format("{} in {} at {}", in_quotes(node.name),
                                             in_quotes(probed.what.solid), probed.what.place);
  const PrimitiveKind kind = node.primitive()->kind;
  const std::string face =
      face_count(kind) == 1 ? "" : fmt::format(", face {}", face_name(kind, probed.pick.face));
  return fmt::format("{}: {}{}, surface {}   ({:.5g}, {:.5g}, {:.5g})   t {:.5g}", name,
                     name_of(kind), face, probed.pick.surface, point.x, point.y, point.z,
                     probed.pick.t);
}

NodePtr ModelProbe::shown(const modeler::Interpreter& interpreter) {
  std::vector<NodePtr> parts;
  if (is_alone(interpreter)) {
    parts.push_back(interpreter.solids().find(interpreter.selection()->solid)->solid.tree());
  } else {
    for (const auto& [place, entry] : interpreter.solids().entries())
      parts.push_back(entry->solid.tree());
  }
  if (parts != parts_) {
    shown_ = as_one(parts);
    parts_ = std::move(parts);
    picker_.reset();
  }
  return shown_;
}

std::optional<Probed> ModelProbe::at(const modeler::Interpreter& interpreter, ImageSize size,
                                     int column, int row) {
  if (column < 0 || row < 0 || column >= size.width || row >= size.height) return std::nullopt;
  const NodePtr tree = shown(interpreter);
  if (!tree) return std::nullopt;
  const CameraFile camera = interpreter.camera();
  if (!picker_ || !(size == size_) || !modeler::same(camera, camera_))
    picker_ = std::make_unique<modeler::Picker>(tree, camera, size);
  camera_ = camera;
  size_ = size;
  const auto pick = picker_->at(column, row);
  if (!pick) return std::nullopt;
  return Probed{*pick, find(interpreter, *pick)};
}

}  // namespace sir::viewer
