// The price list in sentences: what a person wants to know of it.
#pragma once

#include <string>
#include <vector>

#include "cli/cost/cost_data.h"

namespace sir::cli {

/// "costs 2.30x", from paired ratios. Where their quartiles have 1 between them
/// "costs nothing measurable"; of fewer than three runs the number says so.
std::string cost_in_words(const Spread& ratio);

/// "for +6.1 dB", from the PSNRs of two different pictures against one truth.
std::string gain_in_words(const std::optional<double>& from, const std::optional<double>& to);

/// "removes 214 wrong pixels", from two numbers of them.
std::string removal_in_words(std::size_t from, std::size_t to);

/// How much of the pictures' PSNR is noise: that between two truths of one kind.
std::string noise_in_words(const std::optional<double>& psnr);

/// With a capital and a full stop.
std::string as_sentence(std::string words);

/// All sentences that the tracer's rows allow; rows that are not there are not
/// spoken of. Rows must be settled.
std::vector<std::string> tracer_sentences(const CostPart& part);

/// Likewise of the LUT's rows.
std::vector<std::string> lut_sentences(const CostPart& part);

/// Those of them that speak of the method `best`, of mapping by the eye and of dither: what they
/// gain to the eye, where that is what they are for. lut_sentences() has them.
std::vector<std::string> best_sentences(const CostPart& part);

}  // namespace sir::cli
