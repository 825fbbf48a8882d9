// Which part of a solid is at a pixel: RAY-TRACING (thesis 2.3.6) for the hand that points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

#include "modeler/node.h"
#include "tracer/model.h"
#include "tracer/scene.h"
#include "tracer/trace.h"

namespace sir::modeler {

/// What the primary ray through a pixel meets first.
struct Pick {
  const Node* node = nullptr;  ///< the primitive; lives as long as the picker
  std::size_t place = 0;       ///< of it in preorder(): a node may be in a tree twice
  int face = 0;                ///< as in the .CSG
  std::int64_t surface = 0;    ///< number
  double t = 0;                ///< in units of the ray's direction, from the screen on
  glm::dvec3 point{0};         ///< in SC_CENA
};

/// A solid made ready to be asked about many pixels. For one thread.
class Picker {
 public:
  Picker(NodePtr solid, const CameraFile& camera, ImageSize size);

  /// None: the background.
  std::optional<Pick> at(int column, int row);

 private:
  NodePtr solid_;
  ImageSize size_;
  Scene scene_;
  std::vector<const Node*> nodes_;                        // in preorder
  std::unordered_map<std::int64_t, std::size_t> places_;  // by the numbers of the scene
  std::unique_ptr<const Model<double>> model_;  // at a place of its own: the tracer refers to it
  Tracer<double> tracer_;
};

}  // namespace sir::modeler
