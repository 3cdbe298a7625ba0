#include "core/process/parallel.h"

#include <algorithm>

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace mrsim {

int resolve_threads(int threads) {
  return threads > 0 ? threads : tbb::info::default_concurrency();
}

void with_threads(int threads, const std::function<void()>& body) {
  // TBB warns on stderr of more threads than it has.
  tbb::task_arena arena(std::min(resolve_threads(threads), tbb::info::default_concurrency()));
  arena.execute(body);
}

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body,
                  std::size_t grain) {
  if (resolve_threads(threads) == 1) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  with_threads(threads, [&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
                      });
  });
}

}  // namespace mrsim
