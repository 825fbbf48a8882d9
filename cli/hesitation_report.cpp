#include "cli/hesitation_report.h"

#include <algorithm>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sir::cli {
namespace {

struct Row {
  std::int64_t node;
  std::string name;
  HesitationMap::Count count;
};

std::vector<Row> rows_of(const Scene& scene, const HesitationMap& map) {
  std::unordered_map<std::int64_t, const CsgNode*> nodes;
  for (const CsgNode& node : scene.tree.nodes) nodes.emplace(node.number, &node);
  std::vector<Row> rows;
  for (const auto& [number, count] : map.nodes)
    rows.push_back({number, nodes.at(number)->name, count});
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return a.count.precision + a.count.rounding > b.count.precision + b.count.rounding;
  });
  return rows;
}

}  // namespace

std::string hesitation_table(const Scene& scene, const HesitationMap& map) {
  if (map.nodes.empty()) return fmt::format("none of {} pixels hesitates\n", map.size.pixels());
  std::string text = fmt::format("{} pixels: {} depend on the precision, {} on rounding\n",
                                 map.size.pixels(), map.pixels.precision, map.pixels.rounding);
  text += fmt::format("{:>9}  {:>9}  node\n", "precision", "rounding");
  for (const Row& row : rows_of(scene, map))
    text += fmt::format("{:>9}  {:>9}  {} {}\n", row.count.precision, row.count.rounding, row.node,
                        row.name);
  return text;
}

nlohmann::ordered_json hesitation_json(const Scene& scene, const HesitationMap& map) {
  auto nodes = nlohmann::ordered_json::array();
  for (const Row& row : rows_of(scene, map))
    nodes.push_back({{"node", row.node},
                     {"name", row.name},
                     {"precision", row.count.precision},
                     {"rounding", row.count.rounding}});
  return {{"precision", map.pixels.precision}, {"rounding", map.pixels.rounding}, {"nodes", nodes}};
}

}  // namespace sir::cli
