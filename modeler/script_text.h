// From a solid back to the commands that make it.
#pragma once

#include <string>

#include "modeler/node.h"

namespace sir::modeler {

/// A script that builds the solid bit for bit and saves it as `save_as`: the .CSG it writes is the
/// one that the solid would be saved as. Placements are scale, rotate (by quarter turns) and
/// translate where these give the same bits, else a matrix. Names that repeat are told apart by
/// numbers behind them and set right by label.
std::string script_text(const Node& tree, const std::string& save_as);

}  // namespace sir::modeler
