// Options of the commands that trace.
#pragma once

#include "cli/add_option.h"
#include "tracer/render.h"

namespace sir::cli {

void add_precision(CLI::App* app, Precision& precision);
void add_engine(CLI::App* app, Engine& engine);
void add_formulas(CLI::App* app, Formulas& formulas);
void add_antialias(CLI::App* app, AntialiasOptions& antialias);
void add_threads(CLI::App* app, int& threads);

/// Size, depth, cutoff, past-limit, precision, effects and engine.
void add_tracing(CLI::App* app, RenderOptions& options);

}  // namespace sir::cli
