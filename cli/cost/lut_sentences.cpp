#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cli/cost/sentences.h"
#include "tracer/text_file.h"

namespace sir::cli {
namespace {

// What a row gives instead of another one.
std::string compared(const CostRow& row, const CostRow& base) {
  return as_sentence(fmt::format(
      "{} instead of {} {} {}", row.subject, base.subject, cost_in_words(ratio_of(row.ms, base.ms)),
      row.picture.psnr == base.picture.psnr && row.changed == 0 && base.changed == 0
          ? "and changes no pixel"
          : gain_in_words(base.picture.psnr, row.picture.psnr)));
}

bool is_told_by_best_sentences(const CostRow& row) {
  return row.knob == Knob::effort || row.knob == Knob::map || row.knob == Knob::dither;
}

}  // namespace

std::vector<std::string> lut_sentences(const CostPart& part) {
  std::vector<std::string> sentences;
  const CostRow& usual = part.rows.front();
  const auto rgb = std::find_if(part.rows.begin(), part.rows.end(), [](const CostRow& row) {
    return row.name == "median rgb --split pixels" || row.name == "median rgb --rgb-bits 5";
  });
  const CostRow* best = &usual;
  for (const CostRow& row : part.rows) {
    if (comparable(row.picture.psnr) > comparable(best->picture.psnr)) best = &row;
    if (&row == &usual || is_told_by_best_sentences(row)) continue;
    const bool of_rgb = row.family == "rgb grid" && rgb != part.rows.end();
    if (of_rgb && &row != &*rgb) sentences.push_back(compared(row, *rgb));
    else if (row.front || row.knob == Knob::sample || row.knob == Knob::nearest)
      sentences.push_back(compared(row, usual));
  }
  if (best != &usual && best->picture.psnr)
    sentences.push_back(fmt::format("The most accurate of these is {}: {:.2f} dB.", best->name,
                                    *best->picture.psnr));
  for (std::string& sentence : best_sentences(part)) sentences.push_back(std::move(sentence));
  return sentences;
}

}  // namespace sir::cli
