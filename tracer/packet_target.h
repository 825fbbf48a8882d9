// Which of the instruction sets that packets are compiled for is used. What Highway's
// library does, which takes milliseconds to load; its headers do the rest.
#pragma once

#include <cstdint>

#include <hwy/highway.h>

namespace sir {

/// The choice, for all packets: the best that this machine has. Tests update() it.
hwy::ChosenTarget& packet_target();

/// Instruction sets of this machine, in Highway's bits; the one of no vectors is always
/// among them.
std::int64_t instruction_sets();

}  // namespace sir

/// Calls FUNCTION, compiled for each target of HWY_TARGETS, for the chosen one. In
/// place of HWY_EXPORT and HWY_DYNAMIC_DISPATCH.
#if (HWY_TARGETS & (HWY_TARGETS - 1)) == 0
#define SIR_DISPATCH(FUNCTION) HWY_STATIC_DISPATCH(FUNCTION)
#else
#define SIR_DISPATCH(FUNCTION)                                                     \
  ([] {                                                                            \
    static constexpr decltype(&HWY_STATIC_DISPATCH(FUNCTION)) kTable[] = {         \
        nullptr, HWY_CHOOSE_TARGET_LIST(FUNCTION), HWY_CHOOSE_FALLBACK(FUNCTION)}; \
    return kTable[sir::packet_target().GetIndex()];                                \
  }())
#endif
