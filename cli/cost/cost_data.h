// The price list as it was measured: rows, the two parts of an image, and what was asked.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/cost/difference.h"
#include "cli/cost/knob.h"
#include "cli/cost/timing.h"
#include "quant/choose.h"

namespace sir::cli {

/// What only a row of the LUT's part has.
struct LutFigures {
  std::size_t colours = 0;  ///< see ChosenLut
  std::size_t entries = 0;
  std::vector<double> choose_ms, map_ms;  ///< the run's two halves
  double rmse = 0, de_p95 = 0, hue_loss = 0;
  double de_blurred = 0;  ///< mean CIEDE2000 from where single pixels are not told apart
};

/// A setting and its price.
struct CostRow {
  std::optional<Knob> knob;  ///< none: the default, or the person's own row
  std::string name;          ///< as in the table: "float"
  std::string subject;       ///< as in a sentence: "float"
  std::string family;        ///< rows of one curve
  double at = 0;             ///< the row's place on it

  std::vector<double> ms;              ///< a run each: render, or choose and map
  Difference picture;                  ///< from the true picture
  std::optional<Difference> points;    ///< one-ray settings: from the true colours of the points
  std::size_t changed = 0;             ///< pixels that differ from the default's picture
  std::optional<std::size_t> rounded;  ///< pixels that differ from the default in long double
  std::optional<LutFigures> lut;

  Spread time, ratio;  ///< of `ms`; of `ms` over the default's
  bool front = false;  ///< on the Pareto front of time and the picture's PSNR
};

/// Rows of which the first is the default.
struct CostPart {
  std::vector<CostRow> rows;
  std::vector<std::string> sentences;
};

/// Fills in what follows from the rows' runs and differences: time, ratio, front.
void settle(CostPart& part);

/// What was asked for: the most accurate within a time, the cheapest at a PSNR.
struct CostQuestion {
  std::optional<double> budget_ms, target_db;
};

/// The row that answers, or none and the words why.
struct CostAnswer {
  std::string question;  ///< "within 2 s"
  std::optional<std::size_t> row;
  std::string text;  ///< a sentence
  bool of_tracer = false;
};

struct CostImage {
  std::string name;
  ImageSize size;
  std::optional<CostPart> tracer, lut;
  std::vector<CostAnswer> answers;
  std::string truth;                  ///< the tracer's, in words
  std::optional<double> truth_noise;  ///< PSNR between it and another such picture
};

struct CostReport {
  std::vector<CostImage> images;
  int threads = 1;
  int repeats = 5;
  int truth_samples = 64;
};

}  // namespace sir::cli
