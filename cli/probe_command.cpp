#include "cli/probe_command.h"

#include <string>

#include "cli/line_input.h"
#include "tracer/probe_text.h"
#include "tracer/scene_file.h"

namespace sir::cli {

int run_probe(const ProbeCommand& command, int descriptor, const Session&) {
  const Scene scene = read_scene(command.base);
  const auto prober = make_prober(scene, command.precision, command.engine);
  bool all_good = true;
  std::string text;
  const auto answer = [&](std::string_view line, bool too_long) {
    if (too_long) append_probe_error("the line is too long", text);
    all_good = !too_long && answer_ray(*prober, line, text) && all_good;
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
