// Our own times, without reading and preparing: how they grow, and what the tree's shape, a
// cut and a second thread do to them.
#pragma once

#include "bench/peers_table.h"

namespace sir::bench {

/// Growth exponent from 300 to 30,000 primitives in double and float; a chain against a
/// balanced tree, and the cut scene against the whole one, at each size.
void measure_growth(int rounds, SpeedTable& table);

/// Wall time on one thread over that on two.
void measure_threads(int rounds, SpeedTable& table);

}  // namespace sir::bench
