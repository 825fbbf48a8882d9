#include "modeler/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace sir::modeler {
namespace {

double length_of(const glm::dvec3& way) {
  return std::abs(way.x) + std::abs(way.y) + std::abs(way.z);
}

// Of the longest translation; infinite where one of the matrices cannot be a solid's at all.
double reach_of(const Node& tree) {
  double reach = 0;
  for (const Node* node : preorder(tree)) {
    const Primitive* primitive = node->primitive();
    if (primitive == nullptr) continue;
    if (!is_usable(primitive->local_cena)) return std::numeric_limits<double>::infinity();
    reach = std::max(reach, length_of(primitive->local_cena.translation));
  }
  return reach;
}

}  // namespace

Solid::Solid(NodePtr tree) : base_(tree), near_(std::move(tree)) {}

const NodePtr& Solid::tree() const {
  if (near_path_ != path_) {
    std::vector<const Edit*> edits;
    for (const Path* at = path_.get(); at != near_path_.get(); at = at->before.get())
      edits.push_back(&at->edit);
    std::reverse(edits.begin(), edits.end());
    near_ = modeler::edited(std::move(near_), edits);
    near_path_ = path_;
  }
  return near_;
}

// Whether a translation by this leaves all matrices usable, whatever the tree is.
bool Solid::bears(const glm::dvec3& way) const {
  constexpr double kFarthest = 1e300;  // far from where sums become infinite
  if (!reach_) reach_ = reach_of(*tree());
  return *reach_ + length_of(way) <= kFarthest;
}

Solid Solid::edited(Edit edit) const {
  // A translation needs nothing from the tree, and cannot be refused: a hand that drags gives
  // hundreds of them, scripts thousands.
  const Step* step = std::get_if<Step>(&edit.change);
  const bool waits = composite() && edit.place == 0 && step != nullptr &&
                     step->kind == Step::Kind::translation && bears(step->translation);
  NodePtr result;
  if (!waits) {
    result = modeler::edited(tree(), edit);
    // A primitive is no larger than the way to it.
    if (!composite()) return Solid(std::move(result));
  }
  const bool goes_on = steps_ < most_steps(count());
  Solid solid(goes_on ? base_ : tree());
  if (goes_on) {
    solid.near_ = near_;
    solid.near_path_ = near_path_;
  }
  if (waits) solid.reach_ = *reach_ + length_of(step->translation);
  solid.path_ = std::make_shared<const Path>(Path{std::move(edit), goes_on ? path_ : nullptr});
  solid.steps_ = goes_on ? steps_ + 1 : 1;
  if (result) {
    solid.near_ = std::move(result);
    solid.near_path_ = solid.path_;
  }
  return solid;
}

void Solid::forget_tree() const {
  near_ = base_;
  near_path_ = nullptr;
}

std::size_t Solid::most_steps(std::size_t nodes) {
  constexpr std::size_t kMostWork = std::size_t{1} << 21;  // nodes
  return std::max<std::size_t>(kMostSteps, std::min(nodes, kMostWork / nodes));
}

}  // namespace sir::modeler
