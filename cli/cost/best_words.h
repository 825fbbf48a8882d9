// What the price list calls the method `best`, in its rows and in the sentences that look for them.
#pragma once

#include <string>

#include "quant/best.h"

namespace sir::cli {

/// Rows of one curve (CostRow::family), by effort.
inline constexpr const char *kBestByEye = "best, perceptual", *kBestByBytes = "best, psnr";

/// The row of a LUT that was chosen by the eye and is mapped by the bytes.
inline constexpr const char* kBestMappedByBytes = "best, --map rgb";

/// "best --goal psnr --effort 5"; the goal is left out where it is the default.
std::string best_name(quant::Goal goal = quant::Goal::perceptual, int effort = quant::kUsualEffort);

}  // namespace sir::cli
