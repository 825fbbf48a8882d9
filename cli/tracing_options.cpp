#include "cli/tracing_options.h"

#include <limits>

#include "cli/option_values.h"

namespace sir::cli {

void add_precision(CLI::App* app, Precision& precision) {
  add_choice(app, "--precision", precision,
             {{"double", Precision::double_},
              {"float", Precision::float_},
              {"long-double", Precision::long_double}},
             "scalar type of all tracing (double)");
}

void add_engine(CLI::App* app, Engine& engine) {
  add_choice(app, "--engine", engine,
             {{"gates", Engine::gates}, {"roth", Engine::roth}, {"envelopes", Engine::envelopes}},
             "how boundaries are found: fast, by the thesis's plain algorithm, or by that with an "
             "envelope at each node (gates)");
}

void add_formulas(CLI::App* app, Formulas& formulas) {
  add_choice(app, "--formulas", formulas,
             {{"robust", Formulas::robust}, {"textbook", Formulas::textbook}},
             "how primitives are intersected: surely, or as in textbooks, for measuring what "
             "robustness costs and saves (robust)");
}

void add_antialias(CLI::App* app, AntialiasOptions& antialias) {
  add_parsed(app, "--antialias", antialias, parse_antialias,
             {"none|adaptive[:T[:L]]|random[:N[:SEED]]",
              "none, adaptive[:THRESHOLD[:LEVELS]] with a threshold of 0 to 255 and 0 to 6 levels, "
              "or random[:SAMPLES[:SEED]] with 1 to 4096 samples and a seed below 2^63"},
             "more than one ray a pixel: through its corners, and more where they differ by more "
             "than T levels of 255, divided L times at most (16:2); or N scattered ones (16:1)");
}

void add_threads(CLI::App* app, int& threads) {
  app->add_option("--threads", threads, "threads (as many as cores)")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
}

void add_tracing(CLI::App* app, RenderOptions& options) {
  TraceOptions& trace = options.trace;
  add_size(app, options.size, "image size (640x480)");
  app->add_option("--depth", trace.depth_limit, "depth limit of the tree of rays (5)")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N");
  add_number(app, "--cutoff", trace.cutoff, 0, std::numeric_limits<double>::max(),
             "least weight of a secondary ray (0)");
  add_choice(app, "--past-limit", trace.past_limit,
             {{"zero", PastLimit::zero}, {"background", PastLimit::background}},
             "what rays past the depth limit see (zero)");
  add_precision(app, options.precision);
  add_parsed(app, "--effects", trace.allowed_effects, parse_effects,
             {"auto|all|LIST", "auto, all, or a list out of " + known_effects()},
             "LIST: of " + known_effects() + ", separated by commas (auto)");
  add_engine(app, trace.engine);
}

}  // namespace sir::cli
