#include "bench/peers_growth.h"

#include <cmath>
#include <cstdio>
#include <iterator>

#include "bench/child.h"
#include "bench/scenes.h"
#include "bench/timing.h"
#include "tracer/render.h"

namespace sir::bench {
namespace {

RenderOptions frame_options() {
  RenderOptions options;
  options.size = {500, 500};
  options.threads = 1;
  options.trace.depth_limit = 1;
  return options;
}

template <typename T>
Model<T> model_of(const MadeScene& made) {
  return Model<T>(made_scene(made), frame_options().trace.possible_effects());
}

// CPU seconds of a whole frame.
template <typename T>
double frame_seconds(const Model<T>& model) {
  const double start = own_cpu_seconds();
  (void)render_model(model, frame_options());
  return own_cpu_seconds() - start;
}

// One size's scenes.
struct Group {
  int primitives;
  Model<double> balanced, chain, cut;
  Model<float> in_float;
  std::vector<double> t_balanced, t_chain, t_cut, t_float;

  explicit Group(int n)
      : primitives(n),
        balanced(model_of<double>({.primitives = n})),
        chain(model_of<double>({.primitives = n, .chain = true})),
        cut(model_of<double>({.primitives = n, .cut = MadeScene::Cut::root})),
        in_float(model_of<float>({.primitives = n})) {}

  void run() {
    t_balanced.push_back(frame_seconds(balanced));
    t_chain.push_back(frame_seconds(chain));
    t_cut.push_back(frame_seconds(cut));
    t_float.push_back(frame_seconds(in_float));
  }
};

std::vector<double> exponents(const std::vector<double>& small, const std::vector<double>& large,
                              double growth) {
  std::vector<double> values = ratios(large, small);
  for (double& value : values) value = std::log(value) / std::log(growth);
  return values;
}

std::string milliseconds(const char* a, const std::vector<double>& x, const char* b,
                         const std::vector<double>& y) {
  char text[64];
  std::snprintf(text, sizeof text, "%s %.0f ms / %s %.0f ms", a, 1e3 * median(x), b,
                1e3 * median(y));
  return text;
}

}  // namespace

void measure_growth(int rounds, SpeedTable& table) {
  std::vector<Group> groups;
  groups.reserve(std::size(kSizes));
  for (const int primitives : kSizes) groups.emplace_back(primitives);
  for (int round = 0; round < rounds; ++round)
    for (Group& group : groups) group.run();

  table.begin("our own frames: 500x500, shadows, one thread, CPU time of tracing alone");
  const Group &small = groups.front(), &large = groups.back();
  const double growth = double(large.primitives) / small.primitives;
  const auto tell = [&](const char* what, const std::vector<double>& few,
                        const std::vector<double>& many) {
    table.line(what, milliseconds("300:", few, "30,000:", many),
               Quartiles(exponents(few, many, growth)), {0.25, 0.20, true});
  };
  tell("exponent in double", small.t_balanced, large.t_balanced);
  tell("exponent in float", small.t_float, large.t_float);
  for (const Group& group : groups) {
    const std::string n = std::to_string(group.primitives);
    table.line("double/float " + n,
               milliseconds("double", group.t_balanced, "float", group.t_float),
               Quartiles(ratios(group.t_balanced, group.t_float)));
    table.line("chain/balanced " + n,
               milliseconds("chain", group.t_chain, "balanced", group.t_balanced),
               Quartiles(ratios(group.t_chain, group.t_balanced)), {1.15, 1.05, true});
    table.line("cut/uncut " + n, milliseconds("cut", group.t_cut, "uncut", group.t_balanced),
               Quartiles(ratios(group.t_cut, group.t_balanced)), {2, 1.5, true});
  }
}

void measure_threads(int rounds, SpeedTable& table) {
  table.begin("two threads: 500x500, shadows, wall time of tracing alone");
  for (const int primitives : {3'000, 30'000}) {
    const Model<double> model = model_of<double>({.primitives = primitives});
    std::vector<double> one, two, cpu_one, cpu_two;
    RenderOptions options = frame_options();
    const auto timed = [&](int threads, std::vector<double>& wall, std::vector<double>& cpu) {
      options.threads = threads;
      const double start = own_cpu_seconds();
      wall.push_back(render_model(model, options).trace_seconds);
      cpu.push_back(own_cpu_seconds() - start);
    };
    for (int round = 0; round < rounds; ++round) {
      timed(1, one, cpu_one);
      timed(2, two, cpu_two);
    }
    table.line("two threads " + std::to_string(primitives), milliseconds("one", one, "two", two),
               Quartiles(ratios(one, two)), {1.7, 1.9});
    table.line("", "CPU time of both over that of one", Quartiles(ratios(cpu_two, cpu_one)));
    // Below 1 the machine had other work, and the wall time says little.
    std::vector<double> share = ratios(cpu_one, one);
    table.line("", "CPUs that one thread had", Quartiles(share));
    share = ratios(cpu_two, two);
    table.line("", "CPUs that two threads had", Quartiles(share));
    if (median(share) < 1.9)
      std::printf("  The machine did not give two threads two CPUs: the wall times say nothing.\n");
  }
}

}  // namespace sir::bench
