// Apart from parallel.cpp, which builds for ThreadSanitizer and for other machines replace.
#include "core/process/parallel.h"

#include <algorithm>

namespace mrsim {

void parallel_for_chunks(std::size_t count, int threads, std::size_t chunk,
                         const std::function<void(std::size_t, std::size_t)>& body) {
  parallel_for((count + chunk - 1) / chunk, threads,
               [&](std::size_t k) { body(k * chunk, std::min(count, (k + 1) * chunk)); });
}

}  // namespace mrsim
