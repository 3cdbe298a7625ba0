// parallel.h on one thread, for builds without TBB.
#include "core/process/parallel.h"

namespace mrsim {

int resolve_threads(int) { return 1; }
void with_threads(int, const std::function<void()>& body) { body(); }
void parallel_for(std::size_t count, int, const std::function<void(std::size_t)>& body,
                  std::size_t) {
  for (std::size_t i = 0; i < count; ++i) body(i);
}

}  // namespace mrsim
