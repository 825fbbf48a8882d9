#include "cli/probe_command.h"

#include <cmath>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "cli/line_input.h"
#include "tracer/probe.h"
#include "tracer/scene_file.h"

namespace sir::cli {
namespace {

// Empty where the line is a ray; else what is wrong with it.
std::string parse_ray(const std::vector<std::string_view>& tokens, glm::dvec3& origin,
                      glm::dvec3& direction) {
  if (tokens.size() != 6)
    return fmt::format("six numbers ox oy oz dx dy dz expected, {} found", tokens.size());
  for (int i = 0; i < 6; ++i) {
    double& value = i < 3 ? origin[i] : direction[i - 3];
    if (!parse_number(tokens[static_cast<std::size_t>(i)], value))
      return fmt::format("number {} is not a finite number", i + 1);
  }
  if (direction == glm::dvec3(0)) return "the direction must not be zero";
  return {};
}

void append_hits(std::string& text, const std::vector<ProbeHit>& hits) {
  text += "{\"hits\":[";
  const char* separator = "";
  for (const ProbeHit& hit : hits) {
    fmt::format_to(std::back_inserter(text),
                   "{}{{\"t\":{:.17g},\"side\":\"{}\",\"node\":{},\"face\":{},\"surface\":{}}}",
                   separator, hit.t, hit.entering ? "in" : "out", hit.node, hit.face, hit.surface);
    separator = ",";
  }
  text += "]}\n";
}

}  // namespace

int run_probe(const ProbeCommand& command, int descriptor, const Session&) {
  const Scene scene = read_scene(command.base);
  const auto prober = make_prober(scene, command.precision, command.engine);
  bool all_good = true;
  std::string text;
  const auto answer = [&](std::string_view line, bool too_long) {
    const auto tokens = split_tokens(line);
    if (tokens.empty() && !too_long) return;
    glm::dvec3 origin, direction;
    std::string wrong = too_long ? "the line is too long" : parse_ray(tokens, origin, direction);
    if (wrong.empty()) {
      const auto& hits = prober->hits(origin, direction);
      // JSON has no infinity.
      if (!hits.empty() && !std::isfinite(hits.back().t))
        wrong = "origin, direction and t do not all fit into the range of numbers";
      else append_hits(text, hits);
    }
    if (!wrong.empty()) {
      text += "{\"error\":\"" + wrong + "\"}\n";
      all_good = false;
    }
  };
  const auto flush = [&] {
    print(text);
    flush_output();
    text.clear();
  };
  if (!for_each_line(descriptor, answer, flush)) return kInterrupted;
  return all_good ? kDone : kFailed;
}

}  // namespace sir::cli
