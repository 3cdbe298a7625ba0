#include "core/process/heap.h"

#include <cstdint>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace mrsim {

void grow_heap_in_large_steps() {
#ifdef __GLIBC__
  mallopt(M_TOP_PAD, 64 << 20);
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the most it takes
#endif
}

void grow_heap_in_small_steps() {
#ifdef __GLIBC__
  mallopt(M_TOP_PAD, 1 << 20);
#endif
}

void prefer_huge_pages(const void* begin, std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::size_t kHuge = std::size_t(2) << 20;
  if (bytes < 4 * kHuge) return;
  // Whole pages within the range. A refusal costs time alone.
  const std::size_t past = reinterpret_cast<std::uintptr_t>(begin) % kHuge;
  const std::size_t skipped = past == 0 ? 0 : kHuge - past;
  auto* first = const_cast<char*>(static_cast<const char*>(begin)) + skipped;
  madvise(first, (bytes - skipped) / kHuge * kHuge, MADV_HUGEPAGE);
#else
  (void)begin, (void)bytes;
#endif
}

}  // namespace mrsim
