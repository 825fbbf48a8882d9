#include "cli/cost/best_words.h"

#include <fmt/format.h>

namespace sir::cli {

std::string best_name(quant::Goal goal, int effort) {
  return fmt::format("best{} --effort {}", goal == quant::Goal::psnr ? " --goal psnr" : "", effort);
}

}  // namespace sir::cli
