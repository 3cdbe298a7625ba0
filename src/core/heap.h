// How the process gets its memory. Neither call changes a result.
#pragma once

#include <cstddef>
#include <vector>

namespace mrsim {

/// Call it once in a program, before the first thread: the heap then grows by 64 MB at a time and
/// keeps freed memory. Reason: all threads make hundreds of thousands of leaves of 2 KB at once,
/// and each small growth of the heap halts every thread that is touching new pages. Pages that are
/// not touched cost nothing. Does nothing where the C library has no such settings.
void grow_heap_in_large_steps();

/// Asks for huge pages for a large range that will be touched from end to end.
void prefer_huge_pages(const void* begin, std::size_t bytes);

/// Asks for the cache lines of something that will be read soon.
template <class T>
void prefetch(const T& wanted) {
#if defined(__GNUC__) || defined(__clang__)
  constexpr std::size_t kLine = 64;
  const char* at = reinterpret_cast<const char*>(&wanted);
  for (std::size_t i = 0; i < sizeof(T); i += kLine) __builtin_prefetch(at + i);
#else
  (void)wanted;
#endif
}

/// Room for `count` entries that will be filled, in huge pages where that is much.
template <class T>
void reserve_large(std::vector<T>& column, std::size_t count) {
  column.reserve(count);
  prefer_huge_pages(column.data(), count * sizeof(T));
}

}  // namespace mrsim
