// .CSG (thesis 3.6.1).
#include <algorithm>
#include <limits>
#include <unordered_map>

#include "tracer/error.h"
#include "tracer/numeric.h"
#include "tracer/scene_file.h"

namespace sir {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

// What a composite says of a child before the child need exist.
struct ChildReference {
  std::int64_t number;
  bool composite;
  std::size_t line;  // of the number
};

struct Reader {
  TextFile& file;
  CsgTree tree;
  std::vector<std::array<ChildReference, 2>> children;  // for each node; unused for primitives
  std::unordered_map<std::int64_t, std::size_t> index_of;

  std::string where(const CsgNode& node) const {
    return "node " + std::to_string(node.number) + " " + in_quotes(node.name) + ": ";
  }

  bool read_node_type(const CsgNode& node, const char* what) {
    file.expect(where(node) + what);
    const auto word = fold_keyword(file.line());
    if (word == "composto") return true;
    if (word == "primitivo") return false;
    file.fail(where(node) + what + ": COMPOSTO or PRIMITIVO expected, found " +
              in_quotes(file.line()));
  }

  void read_composite(CsgNode& node, std::array<ChildReference, 2>& child) {
    file.expect(where(node) + "the operation");
    const auto word = fold_keyword(file.line());
    if (word == "uniao") node.operation = Operation::union_of;
    else if (word == "diferenca") node.operation = Operation::difference;
    else if (word == "intersecao") node.operation = Operation::intersection;
    else
      file.fail(where(node) + "unknown operation " + in_quotes(file.line()) +
                " (UNIÃO, DIFERENÇA or INTERSEÇÃO)");
    child[0].composite = read_node_type(node, "type of the left node");
    child[1].composite = read_node_type(node, "type of the right node");
    child[0].number = file.read_count(where(node) + "number of the left node");
    child[0].line = file.line_number();
    child[1].number = file.read_count(where(node) + "number of the right node");
    child[1].line = file.line_number();
  }

  void read_primitive(CsgNode& node) {
    file.expect(where(node) + "the primitive");
    const auto word = fold_keyword(file.line());
    if (word == "cubo") node.kind = PrimitiveKind::cube;
    else if (word == "esfera") node.kind = PrimitiveKind::sphere;
    else if (word == "cone") node.kind = PrimitiveKind::cone;
    else if (word == "cilindro") node.kind = PrimitiveKind::cylinder;
    else
      file.fail(where(node) + "unknown primitive " + in_quotes(file.line()) +
                " (CUBO, ESFERA, CONE or CILINDRO)");
    read_surface_numbers(node);
    read_placement(node);
  }

  void read_surface_numbers(CsgNode& node) {
    file.expect(where(node) + "the surface numbers");
    node.surfaces_line = file.line_number();
    const auto tokens = split_tokens(file.line());
    const auto faces = static_cast<std::size_t>(face_count(node.kind));
    if (tokens.size() != 1 && tokens.size() != faces)
      file.fail(
          where(node) + "1 surface number" +
          (faces > 1 ? " for all faces or " + std::to_string(faces) + ", one per face," : "") +
          " expected; " + std::to_string(tokens.size()) + " found");
    node.surface_per_face = tokens.size() > 1;
    for (std::size_t face = 0; face < faces; ++face) {
      const auto token = tokens[node.surface_per_face ? face : 0];
      if (!parse_count(token, node.surfaces[face]))
        file.fail(where(node) + "surface number " + in_quotes(token) +
                  " is not a non-negative integer");
    }
  }

  void read_placement(CsgNode& node) {
    std::size_t first_line = 0;
    for (int line = 0; line < 4; ++line) {
      std::array<double, 4> row{};
      file.read_numbers(where(node) + "line " + std::to_string(line + 1) + " of LOCAL_CENA", row);
      if (line == 0) first_line = file.line_number();
      if (row[3] != (line == 3 ? 1.0 : 0.0))
        file.fail(where(node) + "the fourth column of LOCAL_CENA must be 0 0 0 1");
      const glm::dvec3 v(row[0], row[1], row[2]);
      if (line < 3) node.placement.linear[line] = v;
      else node.placement.translation = v;
    }
    Inverse inverse;
    if (!invert(node.placement.linear, inverse))
      file.fail_at(first_line, where(node) + "LOCAL_CENA is singular");
  }

  void read_node() {
    CsgNode node;
    node.number = file.read_count("a node's number");
    node.line = file.line_number();
    if (!index_of.emplace(node.number, tree.nodes.size()).second)
      file.fail("node " + std::to_string(node.number) + " stands twice in the file");
    file.expect("the name of node " + std::to_string(node.number));
    node.name = file.line();
    node.composite = read_node_type(node, "type");
    std::array<ChildReference, 2> child{};
    if (node.composite) read_composite(node, child);
    else read_primitive(node);
    tree.nodes.push_back(std::move(node));
    children.push_back(child);
  }

  // Resolves the children and checks that the nodes form one tree.
  void link() {
    std::vector<std::size_t> parent(tree.nodes.size(), kNone);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      CsgNode& node = tree.nodes[i];
      if (!node.composite) continue;
      for (std::size_t side = 0; side < 2; ++side) {
        const ChildReference& reference = children[i][side];
        const auto found = index_of.find(reference.number);
        const std::string child = "node " + std::to_string(reference.number);
        if (found == index_of.end())
          file.fail_at(reference.line, where(node) + child + " is not in the file");
        if (tree.nodes[found->second].composite != reference.composite)
          file.fail_at(reference.line, where(node) + child + " is not " +
                                           (reference.composite ? "COMPOSTO" : "PRIMITIVO"));
        std::size_t& of_child = parent[found->second];
        if (of_child != kNone)
          file.fail_at(reference.line, where(node) + child + " already belongs to node " +
                                           std::to_string(tree.nodes[of_child].number));
        of_child = i;
        (side == 0 ? node.left : node.right) = found->second;
      }
    }
    // Every node has at most one parent: it is a tree if there is one root and
    // no circle, and then the root reaches every node.
    const auto is_root = [&](std::size_t i) { return parent[i] == kNone; };
    std::size_t roots = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      if (!is_root(i)) continue;
      if (++roots == 2)
        file.fail_at(tree.nodes[i].line, where(tree.nodes[i]) + "a second root; node " +
                                             std::to_string(tree.nodes[tree.root].number) +
                                             " is named by none either");
      tree.root = i;
    }
    std::vector<char> reached(tree.nodes.size(), 0);
    std::vector<std::size_t> open;
    if (roots == 1) open.push_back(tree.root);
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      reached[i] = 1;
      if (tree.nodes[i].composite) {
        open.push_back(tree.nodes[i].left);
        open.push_back(tree.nodes[i].right);
      }
    }
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
      if (!reached[i])
        file.fail_at(tree.nodes[i].line,
                     where(tree.nodes[i]) + "belongs to a circle of nodes, not to the tree");
  }
};

}  // namespace

CsgTree read_csg(TextFile& file) {
  Reader reader{file, {}, {}, {}};
  const auto announced = file.read_count("the number of nodes");
  if (announced == 0) file.fail("a scene has at least one node");
  for (std::int64_t i = 0; i < announced; ++i) {
    if (file.at_end())
      file.fail("the file announces " + counted(announced, "node") + " and ends after " +
                std::to_string(i));
    reader.read_node();
  }
  if (file.next()) file.fail("the file announces " + counted(announced, "node") + " and goes on");
  reader.link();
  return std::move(reader.tree);
}

void check_surfaces(const CsgTree& tree, const std::vector<Surface>& surfaces,
                    const std::string& csg_name, const std::string& surfaces_name) {
  std::vector<std::int64_t> known;
  for (const Surface& surface : surfaces) known.push_back(surface.number);
  std::sort(known.begin(), known.end());
  for (const CsgNode& node : tree.nodes) {
    if (node.composite) continue;
    for (int face = 0; face < face_count(node.kind); ++face) {
      const auto number = node.surfaces[static_cast<std::size_t>(face)];
      if (!std::binary_search(known.begin(), known.end(), number))
        throw FileError(csg_name, node.surfaces_line,
                        "node " + std::to_string(node.number) + " " + in_quotes(node.name) +
                            ": surface " + std::to_string(number) + " is not described in " +
                            surfaces_name);
    }
  }
}

}  // namespace sir
