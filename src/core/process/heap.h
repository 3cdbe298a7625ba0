// How the process gets its memory. No call changes a result.
#pragma once

#include <cstddef>
#include <vector>

namespace mrsim {

/// Call it once in a program, before the first thread: the heap then grows by 64 MB at a time and
/// keeps freed memory. Reason: all threads make hundreds of thousands of leaves of 2 KB at once,
/// and each small growth of the heap halts every thread that is touching new pages. Pages that are
/// not touched cost nothing. Does nothing where the C library has no such settings.
void grow_heap_in_large_steps();
/// Lets the heap grow in small steps, for a process whose address space is limited: a large step
/// would fail where a small one fits.
void grow_heap_in_small_steps();

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

/// Bytes that the entries of a column take. Reserved room does not count: it has not been touched.
template <class T>
std::size_t bytes_of(const std::vector<T>& column) {
  return column.size() * sizeof(T);
}

/// Room for `more` entries; where the column has to grow, at once for those to come if the rest of
/// the work brings as many: `done` parts of `all` are done with these.
template <class T>
void reserve_ahead(std::vector<T>& column, std::size_t more, std::size_t done, std::size_t all) {
  const std::size_t needed = column.size() + more;
  if (needed <= column.capacity()) return;
  const double share = static_cast<double>(done) / static_cast<double>(all);
  reserve_large(column, static_cast<std::size_t>(1.1 * static_cast<double>(needed) / share) + 1);
}

}  // namespace mrsim
