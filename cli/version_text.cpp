#include "cli/version_text.h"

#include <string_view>

#include <fmt/format.h>

#include "build_facts.h"
#include "tracer/packet_target.h"

namespace sir::cli {
namespace {

// The best of those that packets of rays are compiled for: Highway's lowest bit.
const char* instruction_set() {
  const std::int64_t usable = instruction_sets() & std::int64_t{HWY_TARGETS};
  return hwy::TargetName(usable & -usable);
}

std::string_view or_none(std::string_view text) { return text.empty() ? "none" : text; }

}  // namespace

std::string version() { return kVersion; }

std::string version_text() {
  return fmt::format(
      "sir {}\n"
      "build         {}, {}\n"
      "flags         {}\n"
      "sanitizers    {}\n"
      "libraries     {}\n"
      "built without {}\n"
      "instructions  {}, of this machine, for packets of rays",
      kVersion, kBuildType, kCompiler, kFlags, or_none(kSanitizers), kLibraries, or_none(kWithout),
      instruction_set());
}

}  // namespace sir::cli
