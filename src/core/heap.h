// How the process gets its memory. Neither call changes a result.
#pragma once

#include <cstddef>
#include <vector>

namespace mrsim {

/// For programs, once, before the first thread: the heap grows by 64 MB at a time and keeps what is
/// freed. A level set is made of hundreds of thousands of leaves of 2 KB on all threads at once;
/// small steps halt the other threads, which are touching new pages, at each of them. Of pages that
/// are not touched nothing is taken. Nothing where the C library has no such settings.
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
