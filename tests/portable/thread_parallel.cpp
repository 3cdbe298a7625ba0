// parallel.h with threads of its own for each loop, for ThreadSanitizer: it sees how these
// begin and end, and what a loop orders, but does not see into the TBB library.
#include "core/process/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <tbb/global_control.h>

namespace mrsim {

int resolve_threads(int threads) {
  return threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
}

void with_threads(int threads, const std::function<void()>& body) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(resolve_threads(threads)));
  body();
}

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body,
                  std::size_t grain) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr fault;
  const auto work = [&] {
    try {
      for (std::size_t i = next.fetch_add(grain); i < count; i = next.fetch_add(grain))
        for (std::size_t k = i; k < std::min(i + grain, count); ++k) body(k);
    } catch (...) {
      next = count;
      const std::scoped_lock lock(mutex);
      if (!fault) fault = std::current_exception();
    }
  };
  const std::size_t most = static_cast<std::size_t>(resolve_threads(threads));
  std::vector<std::thread> others;
  for (std::size_t k = 1; k < std::min(most, (count + grain - 1) / grain); ++k)
    others.emplace_back(work);
  work();
  for (std::thread& t : others) t.join();
  if (fault) std::rethrow_exception(fault);
}

}  // namespace mrsim
