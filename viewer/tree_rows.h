// The trees of composition (thesis 3.2.1) as the rows of a list: of thousands of nodes only those
// that are wanted, so that a window may draw the few that are in sight.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "modeler/lsu.h"

namespace sir::viewer {

/// One row. What it points to lives as long as the solids that it was made of.
struct TreeRow {
  const std::string* solid = nullptr;
  const modeler::Node* node = nullptr;
  std::size_t place = 0;  ///< in preorder() of the solid's tree
  std::size_t depth = 0;
  bool open = false;  ///< its parts are the next rows
};

/// Which rows there are.
class TreeRows {
 public:
  /// All solids, and below a node that is open its two parts. With a filter, every node whose name
  /// holds it, case and accents not counted, whatever is open; all at depth 0.
  std::vector<TreeRow> rows(const modeler::Lsu& solids, std::string_view filter = {}) const;

  void set_open(const std::string& solid, std::size_t place, bool open);

  /// Opens what the node is a part of.
  void reveal(const modeler::Lsu& solids, const std::string& solid, std::size_t place);

 private:
  bool is_open(const std::string& solid, std::size_t place) const;

  std::map<std::string, std::set<std::size_t>, std::less<>> open_;  // places by solids
};

}  // namespace sir::viewer
