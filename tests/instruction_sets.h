// Packets on every instruction set.
#pragma once

#include <cstdint>

#include "tracer/packet_target.h"

namespace sir::test {

/// Instruction sets that packets are compiled for and this machine has, the one of one lane last.
/// `run` is called with the name of each, which is in force meanwhile.
template <typename Run>
void with_each_instruction_set(const Run& run) {
  for (std::int64_t rest = instruction_sets() & HWY_TARGETS; rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    packet_target().Update(target);
    run(hwy::TargetName(target));
  }
  packet_target().Update(instruction_sets());
}

}  // namespace sir::test
