#include "tracer/memory_hints.h"

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

#include <cstdint>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace sir {

void ask_for_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  // Whole pages of the usual large size only: what they hold is used to the end.
  constexpr std::uintptr_t kSize = std::uintptr_t{2} << 20;
  const auto address = reinterpret_cast<std::uintptr_t>(begin);
  const auto first = (address + kSize - 1) / kSize * kSize;
  const auto last = (address + bytes) / kSize * kSize;
  if (first < last) ::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
}

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kNever = 1 << 30, kAtOnce = 8 << 20;  // bytes
  mallopt(M_MMAP_THRESHOLD, kNever);
  mallopt(M_TRIM_THRESHOLD, kNever);
  mallopt(M_TOP_PAD, kAtOnce);
#endif
}

}  // namespace sir
