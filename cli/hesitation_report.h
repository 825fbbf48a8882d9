// What `sir render --hesitation` says beside its picture: which nodes make
// pixels hesitate (for RAY-TRACING, thesis 2.3.6).
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "tracer/hesitation.h"

namespace sir::cli {

/// A table, the nodes that make most pixels hesitate first; one line where
/// there is none.
std::string hesitation_table(const Scene& scene, const HesitationMap& map);

/// {"precision":pixels,"rounding":pixels,"nodes":[{"node":..,"name":..,
/// "precision":..,"rounding":..},...]}, in the table's order.
nlohmann::ordered_json hesitation_json(const Scene& scene, const HesitationMap& map);

}  // namespace sir::cli
