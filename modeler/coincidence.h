// Faces of different primitives that lie in one place: the tracer decides there
// (docs/stability.md), but which surface is seen hangs on the order of the nodes, and a digit more
// would change it.
#pragma once

#include <cstddef>
#include <vector>

#include "modeler/node.h"

namespace sir::modeler {

/// A face of a primitive; faces as in the .CSG.
struct Face {
  const Node* node = nullptr;
  int face = 0;
};
struct Coincidence {
  Face first, second;
};

/// Pairs of faces on the same plane, or on the same curved surface, to 12 digits of the solid's
/// size, whose boxes overlap by more than an edge; in the order of the nodes. At most `most`, and
/// where very many faces lie in one plane not all of them are compared.
std::vector<Coincidence> coincident_faces(const Node& tree, std::size_t most);

}  // namespace sir::modeler
