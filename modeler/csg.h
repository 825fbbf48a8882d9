// From the modeler's trees to the .CSG's nodes and back (thesis 3.6.1).
#pragma once

#include "modeler/node.h"
#include "tracer/scene.h"

namespace sir::modeler {

/// The nodes as the file holds them. Where every node has a number of its own and no two the same,
/// they keep them, and stand in the order of their positions, if these are given likewise, or of
/// their numbers. Else they are numbered from 1, each before its children, the left one first.
/// `numbers_lost`, if given, is set where some had numbers in vain.
CsgTree to_csg(const Node& tree, bool* numbers_lost = nullptr);

/// The solid of a file that has been read. Numbers and positions that to_csg() would
/// give anyhow are not kept as the nodes' own, so that to_csg() gives the file's nodes again.
NodePtr from_csg(const CsgTree& tree);

}  // namespace sir::modeler
