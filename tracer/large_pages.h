// Large pages for large arrays: a scene of ten thousands of primitives is tens of
// megabytes, and to be given them page by page takes longer than to fill them.
#pragma once

#include <cstddef>

namespace sir {

/// Asks the system for large pages behind `bytes` from `begin`, which are about to be
/// filled. No more than a hint: nothing happens where it cannot be followed.
void ask_for_large_pages(void* begin, std::size_t bytes);

/// list.reserve(count) where that many elements, or nearly, are about to come.
template <typename List>
void reserve_all(List& list, std::size_t count) {
  list.reserve(count);
  ask_for_large_pages(list.data(), count * sizeof(typename List::value_type));
}

}  // namespace sir
