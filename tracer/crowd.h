// How many envelopes crowd together somewhere: so many boundaries of a ray may chain
// up to one event (for RAY-TRACING, thesis 2.3.6).
#pragma once

#include <cstdint>

#include "tracer/hierarchy.h"

namespace sir {

/// No more of the boxes come as near as `gap` to one point, along every axis; at least
/// 1. Counted closely up to 64: were there k, then each of these k would have k near
/// it, itself included.
template <typename T>
std::uint32_t crowd_of(const Hierarchy<T>& hierarchy, T gap);

}  // namespace sir
