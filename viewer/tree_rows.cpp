#include "viewer/tree_rows.h"

#include "tracer/text_file.h"

namespace sir::viewer {

using modeler::Node;

bool TreeRows::is_open(const std::string& solid, std::size_t place) const {
  const auto places = open_.find(solid);
  return places != open_.end() && places->second.contains(place);
}

void TreeRows::set_open(const std::string& solid, std::size_t place, bool open) {
  if (open) open_[solid].insert(place);
  else if (const auto places = open_.find(solid); places != open_.end())
    places->second.erase(place);
}

std::vector<TreeRow> TreeRows::rows(const modeler::Lsu& solids, std::string_view filter) const {
  const std::string wanted = fold_keyword(filter);
  std::vector<TreeRow> rows;
  struct Open {
    const Node* node;
    std::size_t place, depth;
  };
  std::vector<Open> stack;
  for (const auto& [unused, entry] : solids.entries()) {
    const Node& tree = *entry->solid.tree();
    if (!wanted.empty()) {
      const std::vector<const Node*> nodes = modeler::preorder(tree);
      for (std::size_t place = 0; place < nodes.size(); ++place) {
        // The root goes by its name in the list.
        const std::string& name = place == 0 ? entry->name : nodes[place]->name;
        if (fold_keyword(name).find(wanted) != std::string::npos)
          rows.push_back({&entry->name, nodes[place], place, 0, false});
      }
      continue;
    }
    stack.push_back({&tree, 0, 0});
    while (!stack.empty()) {
      const Open at = stack.back();
      stack.pop_back();
      const auto* composite = at.node->composite();
      const bool open = composite != nullptr && is_open(entry->name, at.place);
      rows.push_back({&entry->name, at.node, at.place, at.depth, open});
      if (!open) continue;
      stack.push_back(
          {composite->right.get(), at.place + 1 + composite->left->count, at.depth + 1});
      stack.push_back({composite->left.get(), at.place + 1, at.depth + 1});
    }
  }
  return rows;
}

void TreeRows::reveal(const modeler::Lsu& solids, const std::string& solid, std::size_t place) {
  const modeler::EntryPtr entry = solids.find(solid);
  if (!entry) return;
  const Node* node = entry->solid.tree().get();
  if (place >= node->count) return;
  for (std::size_t at = 0; at < place;) {
    open_[solid].insert(at);
    const auto* composite = node->composite();
    const std::size_t right = at + 1 + composite->left->count;
    node = place < right ? composite->left.get() : composite->right.get();
    at = place < right ? at + 1 : right;
  }
}

}  // namespace sir::viewer
