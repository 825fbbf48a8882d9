// A row of the price list as named values, for programs: CSV and JSON hold the same.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "cli/cost/cost_data.h"

namespace sir::cli {

/// Nothing where the row has no such value; an infinite number is the PSNR of
/// equal pictures (JSON: null, CSV: inf).
using FieldValue = std::variant<std::monostate, bool, std::size_t, double, std::string>;

struct CostField {
  const char* key;
  FieldValue (*of)(const CostRow& row);
};

/// In their order.
const std::vector<CostField>& cost_fields();

/// One line a row, RFC 4180: `image`, `part` (tracer or lut), then cost_fields().
/// Numbers read back to the same doubles.
std::string cost_csv(const CostReport& report);

/// An object of `threads`, `repeats`, `truth_samples` and `images`; an image has its name, size,
/// `tracer` with `truth`, `rows` and `sentences` where it has a scene, the LUT's
/// `rows` and `sentences`, and the `answers`.
std::string cost_json(const CostReport& report);

}  // namespace sir::cli
