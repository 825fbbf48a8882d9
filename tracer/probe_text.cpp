#include "tracer/probe_text.h"

#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "tracer/text_file.h"

namespace sir {
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

void append_hits(const std::vector<ProbeHit>& hits, std::string& text) {
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

bool answer_ray(Prober& prober, std::string_view line, std::string& text) {
  const auto tokens = split_tokens(line);
  if (tokens.empty()) return true;
  glm::dvec3 origin, direction;
  if (const std::string wrong = parse_ray(tokens, origin, direction); !wrong.empty()) {
    append_probe_error(wrong, text);
    return false;
  }
  const auto& hits = prober.hits(origin, direction);
  // JSON has no infinity.
  if (!hits.empty() && !std::isfinite(hits.back().t)) {
    append_probe_error("origin, direction and t do not all fit into the range of numbers", text);
    return false;
  }
  append_hits(hits, text);
  return true;
}

void append_probe_error(std::string_view reason, std::string& text) {
  text.append("{\"error\":\"").append(reason).append("\"}\n");
}

}  // namespace sir
