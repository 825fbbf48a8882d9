#include "tracer/packet_target.h"

namespace sir {

std::int64_t instruction_sets() {
  std::int64_t sets = HWY_STATIC_TARGET;
#if HWY_ARCH_X86
  // Highway's SSE4, AVX2 and AVX3 are these levels of the architecture and the
  // instructions for AES. The compiler's library asks the system as well.
  if (__builtin_cpu_supports("ssse3")) sets |= HWY_SSSE3;
  if (__builtin_cpu_supports("aes") && __builtin_cpu_supports("pclmul")) {
    if (__builtin_cpu_supports("x86-64-v2")) sets |= HWY_SSE4;
    if (__builtin_cpu_supports("x86-64-v3")) sets |= HWY_AVX2;
    if (__builtin_cpu_supports("x86-64-v4")) sets |= HWY_AVX3;
  }
#endif
  return sets;
}

hwy::ChosenTarget& packet_target() {
  static hwy::ChosenTarget target;
  static const bool chosen = (target.Update(instruction_sets()), true);
  static_cast<void>(chosen);
  return target;
}

}  // namespace sir
