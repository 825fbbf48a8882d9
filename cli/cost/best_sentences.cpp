#include <algorithm>

#include <fmt/format.h>

#include "cli/cost/best_words.h"
#include "cli/cost/sentences.h"

namespace sir::cli {
namespace {

// Two mean CIEDE2000, the first the base's.
std::string seen_in_words(double from, double to) {
  const std::string before = fmt::format("{:.3f}", from), now = fmt::format("{:.3f}", to);
  return now + (now == before ? " as before" : " instead of " + before);
}

std::string by_eye(const CostRow& row, const CostRow& base) {
  return "for a mean CIEDE2000 of " + seen_in_words(base.picture.de_mean, row.picture.de_mean);
}

std::string by_bytes(const CostRow& row, const CostRow& base) {
  return gain_in_words(base.picture.psnr, row.picture.psnr);
}

// Pixel by pixel dither is noise; what it is for shows after a blur.
std::string from_afar(const CostRow& row, const CostRow& base) {
  return fmt::format(
      "{} after the blur, {} without",
      "for a mean CIEDE2000 of " + seen_in_words(base.lut->de_blurred, row.lut->de_blurred),
      seen_in_words(base.picture.de_mean, row.picture.de_mean));
}

class Sentences {
 public:
  explicit Sentences(const CostPart& part) : part_(part) {}

  std::vector<std::string> operator()() {
    const CostRow& usual = part_.rows.front();
    const CostRow* const best = find(best_name());
    const CostRow* const by_psnr = find(best_name(quant::Goal::psnr));
    if (best) add(*best, usual, by_eye);
    if (by_psnr) add(*by_psnr, usual, by_bytes);
    for (const CostRow& row : part_.rows) {
      const CostRow* const base = row.name.starts_with("best") ? best : &usual;
      if (&row == best || &row == by_psnr || !base) continue;
      const bool utmost = row.at == quant::kMinEffort || row.at == quant::kMaxEffort;
      if (utmost && row.family == kBestByEye) add(row, *base, by_eye);
      if (utmost && row.family == kBestByBytes && by_psnr) add(row, *by_psnr, by_bytes);
      if (row.knob == Knob::map) add(row, *base, by_eye);
      if (row.knob == Knob::dither && row.lut && base->lut) add(row, *base, from_afar);
    }
    nearest_to_the_eye();
    return std::move(sentences_);
  }

 private:
  const CostRow* find(const std::string& name) const {
    const auto found = std::find_if(part_.rows.begin(), part_.rows.end(),
                                    [&](const CostRow& row) { return row.name == name; });
    return found == part_.rows.end() ? nullptr : &*found;
  }

  void add(const CostRow& row, const CostRow& base,
           std::string (*gain)(const CostRow& row, const CostRow& base)) {
    sentences_.push_back(
        as_sentence(fmt::format("{} instead of {} {} {}", row.subject, base.subject,
                                cost_in_words(ratio_of(row.ms, base.ms)), gain(row, base))));
  }

  void nearest_to_the_eye() {
    const CostRow& usual = part_.rows.front();
    if (!usual.lut) return;
    const auto least = [&](auto difference) {
      return std::min_element(
          part_.rows.begin(), part_.rows.end(),
          [&](const CostRow& a, const CostRow& b) { return difference(a) < difference(b); });
    };
    const auto close = least([](const CostRow& row) { return row.picture.de_mean; });
    if (&*close != &usual)
      sentences_.push_back(fmt::format("The nearest to the eye is {}: a mean CIEDE2000 of {:.3f}.",
                                       close->name, close->picture.de_mean));
    const auto far = least([](const CostRow& row) { return row.lut->de_blurred; });
    if (&*far != &usual)
      sentences_.push_back(
          fmt::format("After the blur it is {}: {:.3f}.", far->name, far->lut->de_blurred));
  }

  const CostPart& part_;
  std::vector<std::string> sentences_;
};

}  // namespace

std::vector<std::string> best_sentences(const CostPart& part) { return Sentences(part)(); }

}  // namespace sir::cli
