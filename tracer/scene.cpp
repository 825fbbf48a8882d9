#include "tracer/scene.h"

#include <algorithm>
#include <utility>

namespace sir {

std::size_t depth_of(const CsgTree& tree) {
  std::size_t deepest = 0;
  std::vector<std::pair<std::size_t, std::size_t>> open{{tree.root, 1}};
  while (!open.empty()) {
    const auto [index, depth] = open.back();
    open.pop_back();
    deepest = std::max(deepest, depth);
    const CsgNode& node = tree.nodes[index];
    if (!node.composite) continue;
    open.emplace_back(node.left, depth + 1);
    open.emplace_back(node.right, depth + 1);
  }
  return deepest;
}

}  // namespace sir
