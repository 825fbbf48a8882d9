#include "cli/probe_command.h"

#include <cmath>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "cli/interrupt.h"
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

int run_probe(const ProbeCommand& command, std::istream& in, const Session&) {
  const Scene scene = read_scene(command.base);
  const auto prober = make_prober(scene, command.precision, command.engine);
  bool all_good = true, too_long = false;
  std::string line, text;
  constexpr std::size_t kBlock = 1 << 16;
  while (read_line(in, line, too_long)) {
    if (interrupted()) return kInterrupted;
    const auto tokens = split_tokens(line);
    if (tokens.empty() && !too_long) continue;
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
    // In blocks when rays come in a stream; at once when they are typed.
    if (text.size() > kBlock || in.rdbuf()->in_avail() <= 0) {
      print(text);
      flush_output();
      text.clear();
    }
  }
  print(text);
  return all_good ? kDone : kFailed;
}

}  // namespace sir::cli
