// Memory in large pieces: a scene of ten thousands of primitives is tens of megabytes,
// and to be given them by the system, cleared and page by page, takes longer than to
// fill them. Hints only: nothing happens where they cannot be followed.
#pragma once

#include <cstddef>

namespace sir {

/// Asks the system for large pages behind `bytes` from `begin`, which are about to be
/// filled.
void ask_for_large_pages(void* begin, std::size_t bytes);

/// list.reserve(count) where that many elements, or nearly, are about to come.
template <typename List>
void reserve_all(List& list, std::size_t count) {
  list.reserve(count);
  ask_for_large_pages(list.data(), count * sizeof(typename List::value_type));
}

/// What is freed is not handed back to the system but used again. For programs, at
/// their start.
void keep_freed_memory();

}  // namespace sir
