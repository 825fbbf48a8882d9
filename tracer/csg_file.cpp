// .CSG (thesis 3.6.1).
#include <algorithm>
#include <limits>
#include <unordered_map>

#include "tracer/error.h"
#include "tracer/memory_hints.h"
#include "tracer/numeric.h"
#include "tracer/scene_file.h"

namespace sir {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

// The texts of the format's keywords, as written and as fold_keyword() makes them.
template <typename Value>
struct Keyword {
  std::string_view written, folded;
  Value value;
};
constexpr Keyword<bool> kNodeTypes[] = {{"PRIMITIVO", "primitivo", false},
                                        {"COMPOSTO", "composto", true}};
constexpr Keyword<Operation> kOperations[] = {
    {"UNIÃO", "uniao", Operation::union_of},
    {"DIFERENÇA", "diferenca", Operation::difference},
    {"INTERSEÇÃO", "intersecao", Operation::intersection}};
constexpr Keyword<PrimitiveKind> kKinds[] = {{"CUBO", "cubo", PrimitiveKind::cube},
                                             {"ESFERA", "esfera", PrimitiveKind::sphere},
                                             {"CONE", "cone", PrimitiveKind::cone},
                                             {"CILINDRO", "cilindro", PrimitiveKind::cylinder}};

// False where the line is none of the keywords. Most are written just so, and need no
// folding.
template <typename Value, std::size_t N>
bool read_keyword(std::string_view line, const Keyword<Value> (&keywords)[N], Value& value) {
  for (const auto& keyword : keywords)
    if (line == keyword.written) return value = keyword.value, true;
  const std::string folded = fold_keyword(line);
  for (const auto& keyword : keywords)
    if (folded == keyword.folded) return value = keyword.value, true;
  return false;
}

// What a composite says of a child before the child need exist.
struct ChildReference {
  std::int64_t number;
  bool composite;
  std::size_t line;  // of the number
};

struct Reader {
  TextFile& file;
  CsgTree tree;
  std::vector<std::array<ChildReference, 2>> children;  // of each composite
  // Of nodes whose number does not follow from the first node's.
  std::unordered_map<std::int64_t, std::size_t> index_of;

  // The index of a node; kNone: there is none of this number.
  std::size_t find(std::int64_t number) const {
    if (tree.nodes.empty()) return kNone;
    const auto guess = static_cast<std::size_t>(number - tree.nodes[0].number);
    if (guess < tree.nodes.size() && tree.nodes[guess].number == number) return guess;
    if (index_of.empty()) return kNone;
    const auto found = index_of.find(number);
    return found == index_of.end() ? kNone : found->second;
  }

  // Appends a node; false where there is one of this number already.
  bool add(std::int64_t number) {
    if (find(number) != kNone) return false;
    const std::size_t index = tree.nodes.size();
    tree.nodes.emplace_back().number = number;
    if (static_cast<std::size_t>(number - tree.nodes[0].number) != index)
      index_of.emplace(number, index);
    return true;
  }

  std::string where(const CsgNode& node) const {
    return "node " + std::to_string(node.number) + " " + in_quotes(node.name) + ": ";
  }

  // For TextFile's messages: what stands in this node.
  auto of(const CsgNode& node, std::string_view what) const {
    return [this, &node, what] { return where(node) + std::string(what); };
  }

  bool read_node_type(const CsgNode& node, std::string_view what) {
    file.expect(of(node, what));
    bool composite = false;
    if (!read_keyword(file.line(), kNodeTypes, composite))
      file.fail(where(node) + std::string(what) + ": COMPOSTO or PRIMITIVO expected, found " +
                in_quotes(file.line()));
    return composite;
  }

  void read_composite(CsgNode& node, std::array<ChildReference, 2>& child) {
    file.expect(of(node, "the operation"));
    if (!read_keyword(file.line(), kOperations, node.operation))
      file.fail(where(node) + "unknown operation " + in_quotes(file.line()) +
                " (UNIÃO, DIFERENÇA or INTERSEÇÃO)");
    child[0].composite = read_node_type(node, "type of the left node");
    child[1].composite = read_node_type(node, "type of the right node");
    child[0].number = file.read_count(of(node, "number of the left node"));
    child[0].line = file.line_number();
    child[1].number = file.read_count(of(node, "number of the right node"));
    child[1].line = file.line_number();
  }

  void read_primitive(CsgNode& node) {
    file.expect(of(node, "the primitive"));
    if (!read_keyword(file.line(), kKinds, node.kind))
      file.fail(where(node) + "unknown primitive " + in_quotes(file.line()) +
                " (CUBO, ESFERA, CONE or CILINDRO)");
    read_surface_numbers(node);
    read_placement(node);
  }

  void read_surface_numbers(CsgNode& node) {
    file.expect(of(node, "the surface numbers"));
    node.surfaces_line = file.line_number();
    if (parse_count(file.line(), node.surfaces[0])) {  // one for all faces
      std::fill_n(node.surfaces.begin() + 1, face_count(node.kind) - 1, node.surfaces[0]);
      return;
    }
    const auto tokens = split_tokens(file.line());
    const auto faces = static_cast<std::size_t>(face_count(node.kind));
    if (tokens.size() != 1 && tokens.size() != faces)
      file.fail(
          where(node) + "1 surface number" +
          (faces > 1 ? " for all faces or " + std::to_string(faces) + ", one per face," : "") +
          " expected; " + std::to_string(tokens.size()) + " found");
    node.surface_per_face = tokens.size() > 1;
    for (std::size_t face = 0; face < tokens.size(); ++face)
      if (!parse_count(tokens[face], node.surfaces[face]))
        file.fail(where(node) + "surface number " + in_quotes(tokens[face]) +
                  " is not a non-negative integer");
    for (std::size_t face = tokens.size(); face < faces; ++face)
      node.surfaces[face] = node.surfaces[0];
  }

  void read_placement(CsgNode& node) {
    static constexpr std::string_view kLines[] = {"line 1 of LOCAL_CENA", "line 2 of LOCAL_CENA",
                                                  "line 3 of LOCAL_CENA", "line 4 of LOCAL_CENA"};
    std::size_t first_line = 0;
    for (int line = 0; line < 4; ++line) {
      std::array<double, 4> row{};
      file.read_numbers(of(node, kLines[line]), row);
      if (line == 0) first_line = file.line_number();
      if (row[3] != (line == 3 ? 1.0 : 0.0))
        file.fail(where(node) + "the fourth column of LOCAL_CENA must be 0 0 0 1");
      const glm::dvec3 v(row[0], row[1], row[2]);
      if (line < 3) node.placement.linear[line] = v;
      else node.placement.translation = v;
    }
    if (!is_invertible(node.placement.linear))
      file.fail_at(first_line, where(node) + "LOCAL_CENA is singular");
  }

  void read_node() {
    const std::int64_t number = file.read_count("a node's number");
    if (!add(number)) file.fail("node " + std::to_string(number) + " stands twice in the file");
    CsgNode& node = tree.nodes.back();
    node.line = file.line_number();
    file.expect([&] { return "the name of node " + std::to_string(number); });
    node.name = file.line();
    node.composite = read_node_type(node, "type");
    if (node.composite) read_composite(node, children.emplace_back());
    else read_primitive(node);
  }

  // Resolves the children and checks that the nodes form one tree.
  void link() {
    std::vector<std::size_t> parent(tree.nodes.size(), kNone);
    auto child_of = children.begin();
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      CsgNode& node = tree.nodes[i];
      if (!node.composite) continue;
      for (std::size_t side = 0; side < 2; ++side) {
        const ChildReference& reference = (*child_of)[side];
        const std::size_t child = find(reference.number);
        const auto refuse = [&](const std::string& reason) {
          file.fail_at(reference.line,
                       where(node) + "node " + std::to_string(reference.number) + reason);
        };
        if (child == kNone) refuse(" is not in the file");
        if (tree.nodes[child].composite != reference.composite)
          refuse(std::string(" is not ") + (reference.composite ? "COMPOSTO" : "PRIMITIVO"));
        if (parent[child] != kNone)
          refuse(" already belongs to node " + std::to_string(tree.nodes[parent[child]].number));
        parent[child] = i;
        (side == 0 ? node.left : node.right) = child;
      }
      ++child_of;
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
  require_at_most(file, announced, "nodes");
  if (announced == 0) file.fail("a scene has at least one node");
  // Room for what is announced, but for no more than the file has place for.
  constexpr std::size_t kLeastBytes = 32;  // a node has more
  reserve_all(reader.tree.nodes,
              std::min(static_cast<std::size_t>(announced), file.size() / kLeastBytes));
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
      if (face > 0 && number == node.surfaces[0]) continue;
      if (!std::binary_search(known.begin(), known.end(), number))
        throw FileError(csg_name, node.surfaces_line,
                        "node " + std::to_string(node.number) + " " + in_quotes(node.name) +
                            ": surface " + std::to_string(number) + " is not described in " +
                            surfaces_name);
    }
  }
}

}  // namespace sir
