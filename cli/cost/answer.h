// The most accurate setting within a time, the cheapest that reaches a PSNR.
#pragma once

#include <string_view>

#include "cli/cost/cost_data.h"

namespace sir::cli {

/// "2s" or "500ms": a finite time above zero, in milliseconds. The parsers
/// return false, and leave the value alone, where the text is nothing of the kind.
bool parse_time(std::string_view text, std::optional<double>& milliseconds);

/// "45dB" or "45": a finite number of decibels above zero.
bool parse_decibels(std::string_view text, std::optional<double>& decibels);

/// Answers by the medians of the rows' times and the PSNR of their pictures. Of
/// rows that are equally good the cheapest, then the first. Where no row is good
/// enough the text says what the cheapest costs, or what the best reaches.
CostAnswer within_budget(const CostPart& part, double budget_ms);
CostAnswer at_target(const CostPart& part, double target_db);

/// Milliseconds as a person reads them: "1.25 ms", "340 ms", "2.1 s".
std::string readable_time(double ms);

}  // namespace sir::cli
