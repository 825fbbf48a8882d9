#include "tracer/limits.h"

namespace sir {
namespace {

Limits& in_force() {
  static Limits limits;
  return limits;
}

}  // namespace

const Limits& limits() { return in_force(); }

void set_limits(const Limits& limits) { in_force() = limits; }

std::string at_most(std::size_t limit, const char* things, const char* option) {
  return "at most " + std::to_string(limit) + " " + things + " are taken; " + option +
         " N allows more";
}

}  // namespace sir
