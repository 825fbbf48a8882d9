// The drawings of the report: LUTs as swatches and the clock's plot (thesis 4.4).
#pragma once

#include <string>

#include "cli/table_data.h"

namespace sir::cli {

/// 16 x 16 swatches in LUT order, from the top left, as the DAC shows them.
/// What only repeats the last colour is left empty.
std::string swatches_svg(const quant::Lut& lut, const std::string& label);

/// Seconds of 1989 as measured (across) against those that the clock predicts
/// (up), a point for each image and space, with the line where both are equal.
std::string clock_svg(const ClockReading& reading);

}  // namespace sir::cli
