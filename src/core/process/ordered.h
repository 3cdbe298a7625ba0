// Runs work in parts: several threads make them at once, and they are taken in their order.
#pragma once

#include "core/process/parallel.h"

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace mrsim {

/// Calls take(make(k)) for k = 0, 1, ... count - 1, one after another, while other threads make
/// later parts. A thread waits only where there is nothing else to do. Parts are taken `together`
/// at a time, as soon as that many are ready. At most twice as many parts, and two for each thread,
/// exist at once. Throws what the first faulty part throws.
template <typename Make, typename Take>
void make_in_order(std::size_t count, int threads, Make make, Take take, std::size_t together = 1) {
  struct Part {
    std::optional<decltype(make(std::size_t{}))> made;
    std::exception_ptr error;
  };
  const std::size_t workers = std::min(static_cast<std::size_t>(resolve_threads(threads)), count);
  std::vector<Part> parts(2 * (together + workers) - 2);  // of part k: number k modulo its size
  std::vector<char> done(parts.size(), 0);
  std::mutex mutex;  // of `done` and all below
  std::condition_variable changed;
  std::size_t next = 0, ready = 0, taken = 0;  // first part not begun, not done, not taken
  bool is_taking = false, failed = false;

  const auto make_next = [&](std::unique_lock<std::mutex>& lock) {
    const std::size_t k = next++;
    lock.unlock();
    Part& part = parts[k % parts.size()];
    try {
      part.made.emplace(make(k));
    } catch (...) {
      part.error = std::current_exception();
    }
    lock.lock();
    done[k % parts.size()] = 1;
    while (ready < next && done[ready % parts.size()]) ++ready;
  };
  const auto take_some = [&](std::unique_lock<std::mutex>& lock) {
    const std::size_t first = taken, end = std::min(first + together, ready);
    is_taking = true;
    lock.unlock();
    for (std::size_t k = first; k < end; ++k) {
      Part part = std::move(parts[k % parts.size()]);
      parts[k % parts.size()] = {};
      if (part.error) std::rethrow_exception(part.error);
      take(std::move(*part.made));
    }
    lock.lock();
    for (std::size_t k = first; k < end; ++k) done[k % parts.size()] = 0;
    taken = end;
    is_taking = false;
  };
  parallel_for(workers, threads, [&](std::size_t) {
    std::unique_lock<std::mutex> lock(mutex);
    try {
      while (taken < count && !failed) {
        if (!is_taking && (ready >= taken + together || (ready == count && ready > taken))) {
          take_some(lock);
        } else if (next < count && next < taken + parts.size()) {
          make_next(lock);
        } else {
          changed.wait(lock);
          continue;
        }
        changed.notify_all();
      }
    } catch (...) {
      if (!lock.owns_lock()) lock.lock();
      failed = true;
      changed.notify_all();
      throw;
    }
  });
}

}  // namespace mrsim
