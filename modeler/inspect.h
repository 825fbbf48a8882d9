// Verifica sólido (thesis 3.2.2.10): all that is known of a solid, as text.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "modeler/node.h"

namespace sir::modeler {

/// What to tell (opção_de_verificação).
enum class Aspect { all, bounds, matrices, surfaces, tree, volume, warnings };

/// Name and type, and what was asked for: the bounds in SC_CENA and, by the camera of show, in
/// SC_OBS; LOCAL_CENA and CENA_LOCAL of the primitives; surface numbers; the tree; the volume,
/// found by sampling; and warnings(). With `all` the long parts are cut short. Once a stop is asked
/// for, it ends soon, and what it says is worth nothing.
std::string inspect(const std::string& name, const Node& tree, Aspect aspect = Aspect::all,
                    std::stop_token stop = {});

/// What is probably not meant, a line each: composites that are empty (found by sampling), faces
/// that coincide, matrices that are nearly singular (of condition above 1e8: half of double's
/// digits are lost on the way to SC_LOCAL).
std::vector<std::string> warnings(const Node& tree, std::size_t most_coincidences = 1000,
                                  std::stop_token stop = {});

/// That a composite is empty though its parts are not, where few rays tell it; none for primitives
/// and for composites of so many nodes that it would take long.
std::optional<std::string> empty_warning(const Node& node);

/// The tree of composition, a line a node, each with its place in preorder(), indented. Of more
/// than `most` nodes, and of those more than 40 levels deep, it is said how many are left out.
std::string tree_text(const Node& tree, std::size_t most);

/// "cube", or "difference of "a" and "b", 3 nodes".
std::string type_text(const Node& node);

}  // namespace sir::modeler
