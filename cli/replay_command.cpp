#include "cli/replay_command.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/output_path.h"
#include "eltek/screen_hash.h"
#include "eltek/trace_player.h"
#include "eltek/trace_text.h"
#include "quant/dac_parse.h"
#include "tracer/atomic_file.h"
#include "tracer/error.h"
#include "tracer/text_file.h"
#include "viewer/png_file.h"
#ifdef SIR_WITH_SDL
#include "cli/interrupt.h"
#include "viewer/window.h"
#endif

namespace sir::cli {
namespace {

using eltek::kPorts;
using Counts = std::array<std::uint64_t, kPorts.size()>;

// Accesses by register; each pixel is one.
struct Accesses {
  Counts writes{}, reads{};
  std::uint64_t waits = 0, power_cycles = 0;

  void operator()(const eltek::PortWrite& write) { ++of(writes, write.port); }
  void operator()(const eltek::PortRead& read) { ++of(reads, read.port); }
  void operator()(const eltek::PixelWrite& p) { of(writes, eltek::Port::pixel) += p.count; }
  void operator()(const eltek::PixelRead& p) { of(reads, eltek::Port::pixel) += p.count; }
  void operator()(const eltek::Wait&) { ++waits; }
  void operator()(const eltek::PowerCycle&) { ++power_cycles; }

 private:
  static std::uint64_t& of(Counts& counts, eltek::Port port) {
    return counts[static_cast<std::size_t>(port)];
  }
};

Accesses count(const eltek::TracePlayer& player) {
  Accesses accesses;
  for (std::size_t i = 0; i < player.position(); ++i)
    std::visit(accesses, player.trace().records()[i]);
  return accesses;
}

std::string in_words(const Counts& counts) {
  std::string text;
  for (const eltek::Port port : kPorts)
    if (const auto n = counts[static_cast<std::size_t>(port)]; n > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", eltek::name(port), n);
  return text.empty() ? "none" : text;
}

nlohmann::ordered_json in_json(const Counts& counts) {
  auto json = nlohmann::ordered_json::object();
  for (const eltek::Port port : kPorts)
    if (const auto n = counts[static_cast<std::size_t>(port)]; n > 0)
      json[std::string(eltek::name(port))] = n;
  return json;
}

std::string summary(const eltek::TracePlayer& player, bool indexed, bool json) {
  const Accesses accesses = count(player);
  const quant::DacBits& dac = player.machine().dac();
  const eltek::RasterPosition& beam = player.raster().position();
  const std::string hash = fmt::format("{:016x}", eltek::hash(player.raster().frame()));
  if (json)
    return nlohmann::ordered_json{{"records", player.count()},
                                  {"played", player.position()},
                                  {"dac", dac.bits},
                                  {"writes", in_json(accesses.writes)},
                                  {"reads", in_json(accesses.reads)},
                                  {"waits", accesses.waits},
                                  {"power_cycles", accesses.power_cycles},
                                  {"line", beam.line()},
                                  {"frame", beam.frames()},
                                  {"indexed", indexed},
                                  {"hash", hash}}
               .dump() +
           "\n";
  std::string text = fmt::format("{} of {} played; DAC {}\n", player.position(),
                                 counted(player.count(), "record"), quant::bits_text(dac));
  if (player.position() > 0) text += "last: " + player.describe(player.position() - 1) + "\n";
  text += "writes: " + in_words(accesses.writes) + "\nreads: " + in_words(accesses.reads) + "\n";
  if (accesses.power_cycles > 0) text += fmt::format("power cycles: {}\n", accesses.power_cycles);
  text += fmt::format("beam: line {} of frame {}, after {}\n", beam.line(), beam.frames(),
                      counted(accesses.waits, "wait"));
  return text + fmt::format("frame: {}{}\n", hash, indexed ? "" : ", of more than one palette");
}

// Reads are part of the trace: where the machine gives something else it is not this one's. Empty
// where all are equal.
std::string difference(const eltek::TracePlayer& player) {
  const auto& difference = player.difference();
  if (!difference) return {};
  return fmt::format("record {}: {} reads {} where the trace says {}", difference->record + 1,
                     eltek::name(difference->port), difference->found, difference->expected);
}

#ifdef SIR_WITH_SDL
int step_through(const ReplayOptions& options, const Session& session) {
  eltek::Trace trace = eltek::read_trace(options.trace);
  viewer::ViewerOptions viewer;
  viewer.report = [&session](const std::string& text) { note(session, text); };
  viewer::Window window({}, std::move(viewer));
  window.viewer().replay(std::move(trace), options.trace.filename().string());
  // It has been played to its end by now.
  const std::string wrong = difference(*window.viewer().player());
  if (!wrong.empty()) note(session, options.trace.string() + ": " + wrong);
  if (options.steps) window.viewer().seek(*options.steps);
  window.run(interruption());
  if (interrupted()) return kInterrupted;
  return wrong.empty() ? kDone : kFailed;
}
#else
int step_through(const ReplayOptions&, const Session&) {
  throw FileError("window", 0, "this build has none (it was made without SDL2); use --png OUT.png");
}
#endif

}  // namespace

int run_replay(const ReplayOptions& options, const Session& session) {
  if (options.png) {
    refuse_same_file(*options.png, options.trace);
    require_picture_name(*options.png);
  }
  if (options.window) return step_through(options, session);
  eltek::TracePlayer player(eltek::read_trace(options.trace));
  player.seek(std::min<std::uint64_t>(options.steps.value_or(player.count()), player.count()));
  const auto indexed = player.raster().capture();
  if (options.png) {
    if (indexed) viewer::write_indexed_png(*options.png, *indexed);
    else viewer::write_rgb_png(*options.png, to_planes(player.raster().frame()));
    detail(session, "wrote " + options.png->string());
  }
  print(summary(player, indexed.has_value(), options.json));
  if (const std::string wrong = difference(player); !wrong.empty())
    throw FileError(options.trace.string(), 0, wrong);
  return kDone;
}

void add_replay(CLI::App& app, Action& action) {
  auto* sub = app.add_subcommand(
      "replay", "Do again what a trace of the MA120's registers holds (sir show --trace)");
  const auto options = std::make_shared<ReplayOptions>();
  sub->add_option("FILE", options->trace, "the trace")->required();
  auto* png = sub->add_option(
      "--png", options->png,
      "write the frame as it is then: indexed PNG where it has one palette, else RGB");
  png->type_name("OUT.png");
  sub->add_option_function<std::string>(
         "--steps",
         [options](const std::string& text) {
           std::int64_t steps = 0;
           if (!parse_count(text, steps))
             throw CLI::ValidationError("--steps",
                                        fmt::format("\"{}\" is not a number of records", text));
           options->steps = static_cast<std::uint64_t>(steps);
         },
         "stop after so many records")
      ->type_name("N");
  auto* json = sub->add_flag("--json", options->json, "print JSON");
  sub->add_flag("--window", options->window,
                "step through it in a window: . and , one record, > and < a hundred, Home, End")
      ->excludes(png)
      ->excludes(json);
  sub->callback([&action, options] {
    action = [options](const Session& session) { return run_replay(*options, session); };
  });
}

}  // namespace sir::cli
