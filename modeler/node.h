// The tree of composition (thesis 3.2.1): nodes that never change once they are made, so that
// copies, undo and what another thread looks at share them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "tracer/bounds.h"
#include "tracer/scene.h"

namespace sir::modeler {

struct Node;
using NodePtr = std::shared_ptr<const Node>;

/// ENVOLTORIO: a box along the axes of a frame; empty where low > high.
using Box = Bounds<double>;

/// Nó primitivo. CENA_LOCAL is not kept: it follows from LOCAL_CENA (see inverse_of).
struct Primitive {
  PrimitiveKind kind = PrimitiveKind::cube;
  std::array<std::int64_t, 6> surfaces{};  ///< surface number of each face
  bool surface_per_face = false;           ///< given, and written, one per face
  Placement local_cena;
};

/// Nó composto. Neither pointer is null.
struct Composite {
  Operation operation = Operation::union_of;
  NodePtr left, right;
};

/// What a node keeps of the .CSG it was read from, or was told: its number, and where it stands
/// among the nodes; kNone: as it comes (see to_csg).
struct FileSlot {
  static constexpr std::int64_t kNone = -1;
  std::int64_t number = kNone, position = kNone;
};

/// A node and, by its pointers, all of its solid. A tree may be a chain of any depth: nothing here
/// walks it by recursion, not even its destruction.
struct Node {
  /// Works out the bounds in SC_CENA: of a primitive tight; of a composite by its operation on
  /// those of its children (3.2.2.3): the hull of both, the left one's, or what both share.
  Node(std::string name, Primitive primitive, FileSlot slot = {});
  Node(std::string name, Composite composite, FileSlot slot = {});
  ~Node();
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  const Primitive* primitive() const { return std::get_if<Primitive>(&what); }
  const Composite* composite() const { return std::get_if<Composite>(&what); }

  std::string name;
  FileSlot slot;
  std::variant<Primitive, Composite> what;
  Box bounds;         ///< in SC_CENA
  std::size_t count;  ///< nodes of the tree below, this one included
};

NodePtr make_node(std::string name, Primitive primitive, FileSlot slot = {});
NodePtr make_node(std::string name, Composite composite, FileSlot slot = {});

/// The same solid under another name or in another slot; the children are shared.
NodePtr renamed(const Node& node, std::string name);
NodePtr renumbered(const Node& node, FileSlot slot);

/// All nodes: each before its children, the left one first. They live as long as the tree.
std::vector<const Node*> preorder(const Node& tree);

/// The node at a place of preorder(), found on the way down; null where there is none.
const Node* node_at(const Node& tree, std::size_t place);

/// The bounds that an operation leaves of two.
Box combined(Operation operation, const Box& left, const Box& right);

/// Whether two boxes share a point; touching ones do.
bool meet(const Box& a, const Box& b);

/// Whether there is a point in the box.
bool is_empty(const Box& box);

}  // namespace sir::modeler
