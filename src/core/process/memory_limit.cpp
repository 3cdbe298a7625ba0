#include "core/process/memory_limit.h"

#include "core/process/error.h"

#include <algorithm>
#include <fstream>
#include <limits>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace mrsim {
namespace {

// Bytes of libraries and stacks that a run touches while it works, at most.
constexpr double kTouched = 3e6;
// Factor on the heap in use, for the gaps between its pieces that are too small for anything.
constexpr double kFragments = 1.2;

thread_local std::size_t limit = 0;  // 0: none

// Bytes of the heap that are in use. The resident size would count what was freed and will be
// used again.
double memory_in_use() {
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 33)
  const struct mallinfo2 heap = ::mallinfo2();
  return kProgramMemory + kTouched + kFragments * (double(heap.uordblks) + double(heap.hblkhd));
#else
  return kProgramMemory + kTouched;
#endif
}

double free_memory() {
  const long pages = ::sysconf(_SC_AVPHYS_PAGES), page = ::sysconf(_SC_PAGE_SIZE);
  return pages > 0 && page > 0 ? double(pages) * double(page) : 4e9;
}

// Bytes that the process holds, with what was freed and may be used again.
double memory_held() {
  double pages = 0;
  std::ifstream("/proc/self/statm") >> pages >> pages;  // all, then the resident ones
  return pages * double(::sysconf(_SC_PAGESIZE));
}

}  // namespace

void set_thread_limit(std::size_t bytes) {
  limit = bytes > 0 ? bytes : static_cast<std::size_t>(memory_in_use() + free_memory());
}

MemoryLimit::MemoryLimit(std::size_t bytes) : outer_(limit) { set_thread_limit(bytes); }

MemoryLimit::~MemoryLimit() { limit = outer_; }

double memory_left() {
  if (limit == 0) return std::numeric_limits<double>::infinity();
  return std::max(0.0, double(limit) - memory_in_use());
}

void require_memory(double bytes, const std::string& what, const std::string& advice) {
  const double left = memory_left();
  if (bytes <= left) {
    // What was freed does not fit: it lies in pieces, or in what belongs to other threads.
    if (limit > 0 && memory_held() + bytes > double(limit)) release_freed_memory();
    return;
  }
  throw Error("memory", fmt::format("{} takes about {}, {} of the limit of {} are left; {}", what,
                                    size_text(bytes), size_text(left), size_text(double(limit)),
                                    advice.empty() ? "--max-memory allows more" : advice));
}

std::string size_text(double bytes) {
  if (bytes < 1e3) return fmt::format("{:.0f} bytes", bytes);
  if (bytes < 1e6) return fmt::format("{:.1f} kB", bytes / 1e3);
  if (bytes < 1e9) return fmt::format("{:.1f} MB", bytes / 1e6);
  return fmt::format("{:.2f} GB", bytes / 1e9);
}

void release_freed_memory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

// VmHWM comes first: the peak of getrusage() includes that of the process which started this one.
std::size_t peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (std::size_t kilobytes = 0; word == "VmHWM:" && status >> kilobytes) return kilobytes * 1024;
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

bool has_address_space(std::size_t bytes) {
  void* const room =
      ::mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) return false;
  ::munmap(room, bytes);
  return true;
}

bool is_address_space_limited() {
  rlimit limit{};
  return ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

void require_address_space(int threads) {
  constexpr std::size_t kRun = std::size_t(64) << 20, kThread = std::size_t(16)
                                                                << 20;  // stack, heap
  const std::size_t wanted = kRun + kThread * static_cast<std::size_t>(threads);
  if (!is_address_space_limited() || has_address_space(wanted)) return;
  throw Error("memory",
              fmt::format("a run with {} threads needs {} MB of free address space: raise "
                          "its limit (ulimit -v), or take fewer --threads",
                          threads, wanted >> 20));
}

}  // namespace mrsim
