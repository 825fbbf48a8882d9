// Primary rays on unions of spheres against Embree 3 (Wald et al., Embree: a kernel framework for
// efficient CPU ray tracing, 2014).
#pragma once

#include "bench/peers_table.h"

namespace sir::bench {

/// The nearest hits of 512x512 primary rays on 300, 3,000 and 30,000 spheres, on one thread: by
/// Embree's packets of 16 and 8 rays and one by one, in its float; by ours in float and double.
/// Rays come in the renderer's order, and the filling of packets is part of the time. Contenders
/// take turns. False where the hits are not the same. Built without Embree it says so, and which
/// Debian package it wants, and times ours alone.
bool measure_embree(int rounds, SpeedTable& table);

}  // namespace sir::bench
