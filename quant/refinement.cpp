#include "quant/refinement.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace sir::quant {

struct Refinement::Effort {
  std::size_t points;
  int steps;      // of Lloyd
  double enough;  // a step that saves less of the cost is the last
  int swaps;
  double worth;  // of a swap, see Palette::swap
  int nudges;
  std::size_t tries;  // of a nudge
  bool swaps_on_lattice;
};

const Refinement::Effort Refinement::kEfforts[] = {{8192, 4, 1e-2, 0, 1, 0, 0, false},
                                                   {16384, 6, 2e-3, 4, 1, 6, 4, false},
                                                   {80000, 8, 1e-3, 12, 0.7, 12, 8, false},
                                                   {150000, 20, 1e-4, 40, 0.5, 40, 12, true},
                                                   {500000, 60, 1e-6, 200, 0.4, 200, 26, true}};

namespace {

std::size_t checked(int effort) {
  if (effort < kMinEffort || effort > kMaxEffort)
    throw std::invalid_argument("an effort is from 1 to 5");
  return static_cast<std::size_t>(effort - kMinEffort);
}

}  // namespace

Refinement::Refinement(int effort, ProgressTo progress, std::stop_token stop)
    : effort_(kEfforts[checked(effort)]), progress_(std::move(progress)), stop_(std::move(stop)) {}

std::size_t Refinement::points() const { return effort_.points; }

// Nobody knows beforehand how many steps will gain: each takes a share of what is left.
void Refinement::tell(double share) {
  done_ += (1 - done_) * share;
  if (progress_) progress_(done_);
}

void Refinement::lloyd(Palette& palette) {
  for (int i = 0; i < effort_.steps && !stopped(); ++i) {
    const double saved = palette.step();
    tell(0.01);
    if (saved <= effort_.enough) break;
  }
}

// Many at once as long as that helps, then fewer.
void Refinement::swaps(Palette& palette) {
  std::size_t most = std::max<std::size_t>(palette.size() / 16, 1);
  for (int i = 0; i < effort_.swaps && !stopped(); ++i) {
    const double before = palette.cost();
    const std::size_t moved = palette.swap(most, effort_.worth);
    tell(0.02);
    if (most == 1 && moved == 0) break;
    if (2 * moved < most || palette.cost() > before * (1 - effort_.enough))
      most = std::max<std::size_t>(most / 2, 1);
  }
}

// Entries without colours go where they help: a LUT to start from may repeat its last one. Each
// round may double those that are used.
void Refinement::spend_spare(Palette& palette) {
  while (!stopped()) {
    std::size_t spare = 0;
    for (std::size_t i = 0; i < palette.size(); ++i)
      spare += palette.rule(i).free() && palette.sum(i).points == 0;
    if (spare == 0 || palette.swap(spare, effort_.worth) == 0) break;
  }
}

// Steps may bring entries together again, so more than once.
void Refinement::fill(Palette& palette) {
  constexpr int kMost = 3;
  for (int i = 0; i < kMost && !stopped() && palette.fill() > 0; ++i) lloyd(palette);
}

void Refinement::free(Palette& palette) {
  spend_spare(palette);
  lloyd(palette);
  swaps(palette);
  lloyd(palette);
}

void Refinement::held(Palette& palette) {
  lloyd(palette);
  fill(palette);
  if (effort_.swaps_on_lattice) swaps(palette);
  for (int i = 0; i < effort_.nudges && !stopped(); ++i) {
    const std::size_t moved = palette.nudge(effort_.tries);
    tell(0.05);
    if (moved == 0) break;
  }
  fill(palette);
  lloyd(palette);
}

}  // namespace sir::quant
