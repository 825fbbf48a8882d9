#include "cli/cost/sentences.h"

#include <cmath>

#include <fmt/format.h>

#include "tracer/text_file.h"

namespace sir::cli {
namespace {

constexpr std::size_t kFewRuns = 3;  // below it quartiles say nothing

std::string times(double ratio) {
  return ratio < 9.95 ? fmt::format("{:.2f}x", ratio) : fmt::format("{:.0f}x", ratio);
}

}  // namespace

std::string cost_in_words(const Spread& ratio) {
  const std::string runs =
      ratio.runs < kFewRuns ? fmt::format(" (by {})", counted(ratio.runs, "run")) : "";
  if (ratio.runs < kFewRuns && std::abs(ratio.median - 1) < 0.1)
    return "costs about as much" + runs;
  if (ratio.runs >= kFewRuns && ratio.low <= 1 && ratio.high >= 1)
    return "costs nothing measurable";
  if (std::abs(ratio.median - 1) < 0.005)
    return fmt::format("costs less than 1 % {}", ratio.median > 1 ? "more" : "less");
  return "costs " + times(ratio.median) + runs;
}

std::string gain_in_words(const std::optional<double>& from, const std::optional<double>& to) {
  if (!to) return from ? "and leaves nothing wrong" : "where nothing is wrong";
  if (!from) return fmt::format("and falls from no error to {:.1f} dB", *to);
  const double gain = *to - *from;
  if (std::abs(gain) < 0.005) return "for no gain (less than 0.01 dB)";
  return fmt::format("for {:+.{}f} dB", gain, std::abs(gain) < 0.95 ? 2 : 1);
}

std::string removal_in_words(std::size_t from, std::size_t to) {
  if (from == to)
    return from == 0 ? "and no pixel is wrong in either"
                     : fmt::format("and leaves {} wrong as before", counted(to, "pixel"));
  if (to > from) return fmt::format("and adds {}", counted(to - from, "wrong pixel"));
  return fmt::format("and removes {}{}", counted(from - to, "wrong pixel"),
                     to == 0 ? "" : fmt::format(" of {}", from));
}

std::string noise_in_words(const std::optional<double>& psnr) {
  if (!psnr) return "The true picture has no noise: one of another seed is equal to it.";
  return fmt::format(
      "The true picture has noise of its own: one of another seed is {:.1f} dB from it, so a PSNR "
      "of that order says that the rest is noise.",
      *psnr);
}

std::string as_sentence(std::string words) {
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z')
    words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words + ".";
}

}  // namespace sir::cli
